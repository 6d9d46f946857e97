uniform mat4 view_projection;
uniform int surface;
uniform int is_mesh;    // or a constant, in a program that draws one kind of surface alone
in vec3 stage_position; // of a mesh's corner; of a grid's its place in the unit square, and 0
out vec2 v_st;
out vec3 v_position;
flat out int v_face;
out vec4 v_value;

void main() {
    if (is_mesh == 1) {
        v_st = vec2(0.0);
        v_face = gl_VertexID / 3;
        v_value = mesh_value(surface, stage_position, v_face);
        v_position = mesh_point(surface, stage_position);
    } else {
        v_st = stage_position.xy;
        v_face = 0;
        v_value = surface_value(surface, v_st);
        v_position = surface_point(surface, v_st);
    }
    gl_Position = view_projection * vec4(v_position, 1.0);
}
