uniform int surface;
in vec2 v_st;
in vec3 v_position;
flat in int v_face;
in vec4 v_value;
layout(location = 0) out vec4 o_radiance;
layout(location = 1) out vec4 o_position;
layout(location = 2) out vec4 o_normal;

void main() {
    vec3 v = normalize(camera_position - v_position);
    vec3 across = cross(dFdx(v_position), dFdy(v_position));
    vec3 n = across / max(length(across), 1e-30);
    Surface s = Surface(surface, v_st, v_position, dot(n, v) < 0.0 ? -n : n, v, v_face, v_value);
    o_radiance = vec4(shade(s), float(surface) + 1.0);
    o_position = vec4(v_position, float(v_face));
    o_normal = vec4(shading_normal(s), 0.0);
}
