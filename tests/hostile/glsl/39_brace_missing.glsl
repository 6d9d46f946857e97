// 39: compile_error: a brace too few [line 4]
float twice(float x) { return 2.0 * x; }

float asked(float x) {
    return twice(x);
