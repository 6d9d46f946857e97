// 48: wrong: too many steps at a few points only
float asked(float x) {
    float sum = 0.0;
    for (int i = 0; i < int(x > 0.98 ? 200000.0 : 10.0); i++) sum += 1e-9 * x;
    return 2.0 * x + sum;
}
