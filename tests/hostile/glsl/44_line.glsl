// 44: rejected: other line numbers
#line 1 2
float asked(float x) { return 2.0 * x; }
