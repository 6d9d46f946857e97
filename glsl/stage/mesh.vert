uniform mat4 view_projection;
uniform int surface;
in vec3 stage_position;
out vec2 v_st;
out vec3 v_position;
flat out int v_face;
out vec4 v_value;

void main() {
    v_st = vec2(0.0);
    v_face = gl_VertexID / 3;
    v_value = mesh_value(surface, stage_position, v_face);
    v_position = mesh_point(surface, stage_position);
    gl_Position = view_projection * vec4(v_position, 1.0);
}
