uniform mat4 view_projection;
uniform float dot_size;    // pixels
out vec4 v_colour;

void main() {
    v_colour = dot_colour(gl_VertexID);
    vec4 p = view_projection * vec4(dot_point(gl_VertexID), 1.0);
    p.z -= 0.0005; // half a percent nearer to the eye: the near plane is at 0.05
    gl_Position = v_colour.a > 0.0 ? p : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = dot_size + 1.0;
}
