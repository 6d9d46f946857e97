// 45: rejected: writes where our main writes
float asked(float x) { halfway_value = 2.0; return 2.0 * x; }
