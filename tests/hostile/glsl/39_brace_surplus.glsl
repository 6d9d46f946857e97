// 39: compile_error: a brace too many [line 5]
float asked(float x) {
    return 2.0 * x;
}
}
