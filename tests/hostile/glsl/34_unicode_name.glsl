// 34: rejected: a name of another alphabet
float аsked(float x) { return 2.0 * x; }
