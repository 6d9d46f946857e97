// 46: rejected: asks where it is
float asked(float x) { return 2.0 * x + float(gl_VertexID); }
