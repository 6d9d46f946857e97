// 46: rejected: asks its neighbours
float asked(float x) { return 2.0 * x + dFdx(x); }
