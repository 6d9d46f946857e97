// 44: rejected: another float
#define float int
float asked(float x) { return 2.0 * x; }
