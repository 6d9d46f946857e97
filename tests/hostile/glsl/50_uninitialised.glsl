// 50: wrong: reads what nobody wrote
float asked(float x) {
    float y[64];
    for (int i = 1; i < 64; i++) { y[i] = x; }
    return y[0] + x;
}
