#include "optics/scale_effect.glsl"

// Six waves along the axes of an icosahedron, so that the slopes they make are alike along every direction
const vec3 WAVE[6] = vec3[6](vec3(0.0, 0.5257311, 0.8506508), vec3(0.0, -0.5257311, 0.8506508), vec3(0.5257311, 0.8506508, 0.0),
    vec3(-0.5257311, 0.8506508, 0.0), vec3(0.8506508, 0.0, 0.5257311), vec3(0.8506508, 0.0, -0.5257311));
const float RATE[6] = float[6](1.0, 0.83, 1.17, 0.91, 1.09, 1.26);

float sine_of_turns(float x) {
    float p = fract(x) - 0.5, y = 8.0 * p * (2.0 * abs(p) - 1.0); // a parabola, bent to within 0.001
    return y * (0.775 + 0.225 * abs(y));
}

// The normal of the bumps at a place, each wave as far as a pixel of these sides shows it; w: the mean square slope it hides
vec4 bumpy(vec3 n, vec3 p, vec3 across, vec3 down, float bumps, float bump_slope, bool filtered) {
    vec3 slope = vec3(0.0);
    float hidden = 0.0;
    for (int k = 0; k < 6; k++) {
        float rate = 0.5 * bumps * RATE[k], kept = 1.0, along = dot(WAVE[k], n);
        if (filtered) kept = bump_kept(BALL_PIXELS * rate * length(vec2(dot(WAVE[k], across), dot(WAVE[k], down))));
        slope += WAVE[k] * (kept * sine_of_turns(rate * dot(WAVE[k], p) + 0.37 * float(k)));
        hidden += 0.5 * (1.0 - kept * kept) * (1.0 - along * along);
    }
    slope -= n * dot(n, slope);
    return vec4(n - bump_slope * slope, bump_slope * bump_slope * hidden); // not of unit length
}

// The normal of the bumps, unfiltered, at a place that is `off` pixels from p. The phases of the waves are linear in it:
// those at p and their steps per pixel are worked out once.
struct Waves {
    float at[6];
    vec2 steps[6];
};

Waves waves(vec3 p, vec3 across, vec3 down, float bumps) {
    Waves w;
    for (int k = 0; k < 6; k++) {
        float rate = 0.5 * bumps * RATE[k];
        w.at[k] = fract(rate * dot(WAVE[k], p) + 0.37 * float(k));
        w.steps[k] = rate * vec2(dot(WAVE[k], across), dot(WAVE[k], down));
    }
    return w;
}

vec3 bumpy_near(Waves w, vec3 n, vec2 off, float bump_slope) {
    vec3 slope = vec3(0.0);
    for (int k = 0; k < 6; k++) slope += WAVE[k] * sine_of_turns(w.at[k] + dot(w.steps[k], off));
    return n - bump_slope * (slope - n * dot(n, slope));
}
