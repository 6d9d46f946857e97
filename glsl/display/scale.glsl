#include "display/palette.glsl"

// A value over decades through the theme's map: 0 at `low`, 1 at `high`, a thin dark line at each whole power of ten.
vec3 decades(float value, float low, float high) {
    float at = log(max(value, 1e-30)) / log(10.0);
    vec3 colour = colormap((at - low) / (high - low));
    float line = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-6);
    return value > 0.0 ? mix(colour * 0.25, colour, smoothstep(0.3, 1.3, line)) : colormap(0.0) * 0.55;
}

// A signed error from -1 to 1: blue too little, orange too much, the background's middle for none.
vec3 diverging(float error) {
    vec3 none = mix(palette[COLOUR_QUIET], vec3(1.0), 0.7);
    vec3 end = error < 0.0 ? palette[COLOUR_N] : palette[COLOUR_R];
    return mix(none, end, sqrt(clamp(abs(error), 0.0, 1.0)));
}
