// 45: compile_error: changes its argument [line 2]
float asked(inout float x) { return 2.0 * x; }
