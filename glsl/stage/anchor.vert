uniform int mark;
uniform float mark_t;
out vec4 value;

void main() {
    value = vec4(mark_point(mark, mark_t), 1.0);
    gl_Position = vec4(0.0);
}
