// 44: pass: what may stand at the top
precision highp float;
const float TWO = 2.0;
struct P { float x; };
highp float asked(in highp float x) { P p = P(x); return TWO * p.x; }
