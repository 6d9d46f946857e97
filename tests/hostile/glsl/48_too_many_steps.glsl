// 48: wrong: honest, but more steps than the renderer takes
float asked(float x) {
    float sum = 0.0;
    for (int i = 0; i < 100000; i++) {
        sum += x / 50000.0;
    }
    return sum;
}
