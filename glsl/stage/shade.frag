#include "display/srgb.glsl"
#include "display/faults.glsl"
uniform int surface;
uniform float opacity;
in vec2 v_st;
in vec3 v_position;
flat in int v_face;
in vec4 v_value;
layout(location = 0) out vec4 o_colour;
layout(location = 1) out vec4 o_faults;

void main() {
    vec3 v = normalize(camera_position - v_position);
    vec3 across = cross(dFdx(v_position), dFdy(v_position));
    vec3 n = across / max(length(across), 1e-30);
    Surface s = Surface(surface, v_st, v_position, dot(n, v) < 0.0 ? -n : n, v, v_face, v_value);
    vec3 radiance = shade(s);
    vec3 found = faults(radiance);
    bool faulty = dot(found, vec3(1.0)) > 0.0;
    vec3 colour = faulty ? fault_colour(found, gl_FragCoord.xy) : srgb_from_linear(min(radiance, vec3(1.0)));
    o_colour = vec4(colour, faulty ? 1.0 : opacity);
    o_faults = vec4(found, faulty ? 1.0 : floor(opacity));
}
