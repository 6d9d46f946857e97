// 39: compile_error: a parenthesis too few [line 4]

float asked(float x) {
    return 2.0 * (x;
}
