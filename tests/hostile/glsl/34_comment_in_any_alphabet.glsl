// 34: pass: a comment may be in any
// Grösse, 大きさ, μέγεθος
const float TWO = 2.0;
struct Pair { float a, b; };
float twice(const in highp float x) { Pair p = Pair(x, x); return TWO * p.a; }
float asked(float x) { return twice(x); }
