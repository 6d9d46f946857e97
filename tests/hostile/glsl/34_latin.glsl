// 34: rejected: a letter that GLSL has not
float asked(float x) { float größe = 2.0; return größe * x; }
