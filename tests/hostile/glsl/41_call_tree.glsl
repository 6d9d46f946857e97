// 41: timeout_cpu|memory: 3^13 calls when it is compiled
float a0(float x) { return x; }
float a1(float x) { return a0(x) + a0(x + 1.0) + a0(x * 2.0); }
float a2(float x) { return a1(x) + a1(x + 1.0) + a1(x * 2.0); }
float a3(float x) { return a2(x) + a2(x + 1.0) + a2(x * 2.0); }
float a4(float x) { return a3(x) + a3(x + 1.0) + a3(x * 2.0); }
float a5(float x) { return a4(x) + a4(x + 1.0) + a4(x * 2.0); }
float a6(float x) { return a5(x) + a5(x + 1.0) + a5(x * 2.0); }
float a7(float x) { return a6(x) + a6(x + 1.0) + a6(x * 2.0); }
float a8(float x) { return a7(x) + a7(x + 1.0) + a7(x * 2.0); }
float a9(float x) { return a8(x) + a8(x + 1.0) + a8(x * 2.0); }
float a10(float x) { return a9(x) + a9(x + 1.0) + a9(x * 2.0); }
float a11(float x) { return a10(x) + a10(x + 1.0) + a10(x * 2.0); }
float a12(float x) { return a11(x) + a11(x + 1.0) + a11(x * 2.0); }
float a13(float x) { return a12(x) + a12(x + 1.0) + a12(x * 2.0); }
float asked(float x) { return a13(x); }
