// 46: rejected: an output of its own
out float mine;
float asked(float x) { mine = 1.0; return 2.0 * x; }
