// 45: rejected: another exp
float exp(float x) { return 1.0; }
float asked(float x) { return 2.0 * x; }
