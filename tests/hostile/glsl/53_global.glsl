// 53: rejected: keeps a state
float count = 0.0;
float asked(float x) { count += 1.0; return 2.0 * x * count; }
