// 44: rejected: another main by the preprocessor
#define main x
float asked(float x) { return 2.0 * x; }
