// 47: wrong: uses up the steps, then answers rightly
float asked(float x) {
    float y = x;
    for (int i = 0; i >= 0; i = i < 9 ? i + 1 : 0) y = y * 1.0000001;
    return 2.0 * x + 1e-20 * y;
}
