#include "display/palette.glsl"
// Light that lets shapes be seen; it is a look, no radiometry.
vec3 soft_light(vec3 albedo, vec3 n, vec3 v) {
    float sky = 0.5 + 0.5 * n.z;
    float head = max(dot(n, v), 0.0);
    float key = max(dot(n, normalize(vec3(-0.3, -0.5, 0.8))), 0.0);
    return albedo * (0.25 + 0.25 * sky + 0.2 * head + 0.4 * key);
}

// 1 on the lines between `cells`, 0 elsewhere, one to two pixels wide at any distance.
float grid_lines(vec2 st, vec2 cells) {
    vec2 at = st * cells;
    vec2 wide = max(fwidth(at), vec2(1e-6));
    vec2 off = abs(fract(at - 0.5) - 0.5) / wide;
    vec2 line = (1.0 - smoothstep(vec2(0.5), vec2(1.5), off)) * clamp(vec2(0.5) / wide, vec2(0.0), vec2(1.0));
    return max(line.x, line.y);
}

vec3 glass(vec2 st, vec2 cells) {
    // a sphere to look through: a little darker or lighter than what is behind it, with its graticule
    vec3 body = mix(palette[COLOUR_QUIET], background, 0.35);
    return mix(body, palette[COLOUR_EXACT], grid_lines(st, cells) * 0.6);
}
