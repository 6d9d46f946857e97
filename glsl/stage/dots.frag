#include "display/srgb.glsl"
#include "display/faults.glsl"
uniform float dot_size;
in vec4 v_colour;
layout(location = 0) out vec4 o_colour;
layout(location = 1) out vec4 o_faults;

void main() {
    float d = (length(gl_PointCoord - 0.5) - 0.5) * (dot_size + 1.0) + 0.5;
    float cover = clamp(0.5 - d, 0.0, 1.0) * v_colour.a;
    if (cover <= 0.0) discard;
    vec3 found = faults(v_colour.rgb);
    bool faulty = dot(found, vec3(1.0)) > 0.0;
    o_colour = vec4(faulty ? fault_colour(found, gl_FragCoord.xy) : srgb_from_linear(min(v_colour.rgb, vec3(1.0))), cover);
    o_faults = vec4(found, faulty ? 1.0 : 0.0);
}
