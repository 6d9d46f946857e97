// 43: compile_error: calls itself
float asked(float x) { return x < 1.0 ? 2.0 * x : asked(x - 1.0); }
