// 34: rejected: a space that is none
float asked(float x) { return 2.0 * x; }
