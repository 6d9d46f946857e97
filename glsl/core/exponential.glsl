float one_less_exp(float x) {
    // 1 - e^-x for x >= 0, its series where the difference would cancel
    if (x > 0.5) return 1.0 - exp(-x);
    return x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * (1.0 - x / 6.0 * (1.0 - x / 7.0 * (1.0 - x / 8.0)))))));
}
