#include "display/palette.glsl"

// A value over powers of ten through the theme's map: from `low` to `high`; what is not lit at all is darker still.
vec3 decade_colour(float value, float low, float high) {
    float at = log(max(value, 1e-30)) / log(10.0);
    return value > 0.0 ? colormap((at - low) / (high - low)) : colormap(0.0) * 0.55;
}

// The same with a thin dark line at each whole power of ten from `low` on.
vec3 decades(float value, float low, float high) {
    vec3 colour = decade_colour(value, low, high);
    float at = log(max(value, 1e-30)) / log(10.0);
    float line = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-6);
    return at > low - 0.02 ? mix(colour * 0.25, colour, smoothstep(0.3, 1.3, line)) : colour;
}

// A signed error from -1 to 1: blue too little, orange too much, the background's middle for none.
vec3 diverging(float error) {
    vec3 none = mix(palette[COLOUR_QUIET], vec3(1.0), 0.7);
    vec3 end = error < 0.0 ? palette[COLOUR_N] : palette[COLOUR_R];
    return mix(none, end, sqrt(clamp(abs(error), 0.0, 1.0)));
}
