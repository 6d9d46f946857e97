// 42: rejected: macros that double
#define A x+x
#define B A+A
#define C B+B
float asked(float x) { return C; }
