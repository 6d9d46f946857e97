// 44: compile_error: a comment that swallows what follows [line 3]
float asked(float x) { return 2.0 * x; }
/* and so on
