// 39: compile_error: does not compile [line 4]

float asked(float x) {
    return vec2(x);
}
