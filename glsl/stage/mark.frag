#include "display/palette.glsl"
#include "display/srgb.glsl"
uniform int mark_colour;
uniform int dash;          // 0 solid, 1 dashed, 2 dotted, 3 dash-dot
uniform int tip;           // 0 none, 1 arrow, 2 sun, 3 eye, 4 dot
uniform float line_width;
uniform float tip_size;
in vec3 v_pen;
flat in float v_length;
layout(location = 0) out vec4 o_colour;
layout(location = 1) out vec4 o_faults;

float dash_distance(float along) {
    float w = line_width;
    float at = mod(along, 10.0 * w);
    if (dash == 1) return mod(along, 5.0 * w) - 3.0 * w;
    if (dash == 2) return mod(along, 2.5 * w) - w;
    if (dash == 3) return min(at - 5.0 * w, abs(at - 7.5 * w) - 0.5 * w);
    return -1.0;
}

float tip_distance(vec2 p) {
    float r = length(p);
    float size = tip_size;
    if (tip == 1) return max(abs(p.y) - (0.0 - p.x) * 0.42, -p.x - size);
    if (tip == 2) {
        float ray = abs(sin(4.0 * atan(p.y, p.x))) < 0.45 ? r - 0.95 * size : r - 0.5 * size;
        return min(r - 0.5 * size, ray);
    }
    if (tip == 3) return max(abs(r - 0.62 * size) - 0.14 * size, -1e3) < r - 0.26 * size ? abs(r - 0.62 * size) - 0.14 * size : r - 0.26 * size;
    return r - 0.55 * size;
}

void main() {
    bool in_tip = v_pen.z > 0.5;
    float stop = tip == 1 ? 0.8 * tip_size : 0.0;
    float line = max(abs(v_pen.y) - 0.5 * line_width, max(dash_distance(v_pen.x), v_pen.x - v_length + stop));
    float d = in_tip ? tip_distance(v_pen.xy) : line;
    float cover = clamp(0.5 - d, 0.0, 1.0);
    if (cover <= 0.0) discard;
    o_colour = vec4(srgb_from_linear(palette[mark_colour]), cover);
    o_faults = vec4(0.0);
}
