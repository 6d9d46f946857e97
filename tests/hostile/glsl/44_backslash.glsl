// 44: rejected: a comment that goes on in the next line
float asked(float x) { return 2.0 * x; } // \
float other;
