// 48: pass: as many steps as there may be
float asked(float x) {
    float sum = 0.0;
    for (int i = 0; i < 60000; i++) sum = max(sum, float(i < 59999 ? 0 : 2) * x);
    return sum;
}
