// 45: rejected: the function twice
float asked(float x) { return 2.0 * x; }
float asked(vec2 x) { return 2.0 * x.x; }
