out vec4 value;

void main() {
    value = probe(gl_VertexID);
    gl_Position = vec4(0.0);
}
