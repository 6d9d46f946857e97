// 43: compile_error: two that call each other
float other(float x);
float asked(float x) { return x < 0.5 ? 2.0 * x : other(x); }
float other(float x) { return asked(x - 0.5); }
