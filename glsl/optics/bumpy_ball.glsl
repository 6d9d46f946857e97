#include "core/constants.glsl"
#include "optics/beckmann.glsl"
#include "optics/scale_effect.glsl"

// 64 pixels of a ball 600 pixels wide, its bumps six waves along the axes of an icosahedron; filtering 0: the pixel's
// middle, 1: the mean of `samples` places, 2: m^2 + S, 3: Toksvig

const vec3 BALL_WAVE[6] = vec3[6](vec3(0.0, 0.52573111, 0.85065081), vec3(0.0, -0.52573111, 0.85065081),
    vec3(0.52573111, 0.85065081, 0.0), vec3(-0.52573111, 0.85065081, 0.0), vec3(0.85065081, 0.0, 0.52573111),
    vec3(0.85065081, 0.0, -0.52573111));
const float BALL_RATE[6] = float[6](1.0, 0.83, 1.17, 0.91, 1.09, 1.26);

float ball_error(float bumps, float bump_slope, float m, int samples, int filtering) {
    // Olano and Baker 2010; Toksvig 2005: both against the mean of 224 places of each pixel
    float sum = 0.0, narrow = max(m, SMOOTHEST);
    for (int p = 0; p < 64; p++) {
        vec2 u = fract(0.5 + float(p) * vec2(0.7548777, 0.5698403));
        float r = 0.95 * sqrt(u.x);
        vec2 at = r * vec2(cos(2.0 * PI * u.y), sin(2.0 * PI * u.y));
        vec3 n = vec3(at, sqrt(1.0 - r * r));
        vec2 seen = vec2(0.0); // the truth, and the picture
        for (int way = 0; way < 2; way++) {
            int count = way == 0 ? 224 : filtering == 1 ? samples : 1;
            vec2 start = fract(0.5 + float(way == 0 ? p : p + 7) * vec2(0.618034, 0.324718));
            for (int i = 0; i < count; i++) {
                vec2 off = fract(start + float(i) * vec2(0.7548777, 0.5698403)) - 0.5;
                if (way == 1 && filtering != 1) off = vec2(0.0);
                vec3 slope = vec3(0.0);
                float hidden = 0.0;
                for (int k = 0; k < 6; k++) {
                    float rate = 0.5 * bumps * BALL_RATE[k], kept = 1.0, along = dot(BALL_WAVE[k], n);
                    vec2 a_pixel = (BALL_WAVE[k].xy - BALL_WAVE[k].z * at / n.z) / 300.0;
                    if (way == 1 && filtering > 1) kept = bump_kept(600.0 * rate * length(a_pixel));
                    slope += BALL_WAVE[k] * (kept * sin(2.0 * PI * fract((along + dot(a_pixel, off)) * rate + 0.37 * float(k))));
                    hidden += 0.5 * (1.0 - kept * kept) * (1.0 - along * along);
                }
                vec3 bump = n - bump_slope * (slope - n * dot(n, slope));
                float towards = max(bump.z, 1e-9), slope2 = dot(bump.xy, bump.xy) / (towards * towards), d;
                hidden *= bump_slope * bump_slope;
                if (way == 1 && filtering == 3) {
                    float e = exponent_from_m(min(narrow, 1.0)), less = normal_shortfall(sqrt(0.5 * hidden));
                    d = d_blinn_phong_slope(slope2, e * (1.0 - less) / (1.0 - less + e * less));
                } else {
                    d = d_beckmann_slope(slope2, sqrt(narrow * narrow + hidden));
                }
                seen[way] += d / float(count);
            }
        }
        float off = exp(-0.19 * seen.y) - exp(-0.19 * seen.x);
        sum += off * off / 64.0;
    }
    return sqrt(sum);
}
