// 45: rejected: its own main
float asked(float x) { return 2.0 * x; }
void main() { gl_Position = vec4(0.0); }
