uniform mat4 view_projection;
uniform int surface;
in vec2 stage_st;
out vec2 v_st;
out vec3 v_position;
flat out int v_face;
out vec4 v_value;

void main() {
    v_st = stage_st;
    v_face = 0;
    v_value = surface_value(surface, stage_st);
    v_position = surface_point(surface, stage_st);
    gl_Position = view_projection * vec4(v_position, 1.0);
}
