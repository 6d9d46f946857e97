// 45: missing: another name
float Asked(float x) { return 2.0 * x; }
