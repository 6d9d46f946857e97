// The built-in log errs by up to 6e-7 near 1 (Mesa), where the logarithm itself is small.

float log_one_less(float x) {
    // log(1 - x) for 0 <= x < 1: the odd series of z; beyond a half the built-in
    float z = -x / (2.0 - x), q = z * z;
    return x > 0.5 ? log(1.0 - x) : 2.0 * z * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0 + q * (1.0 / 11.0 + q / 13.0))))));
}

float cosine_power(float cosine, float below, float exponent) {
    // cosine^exponent from the cosine and what it is below 1, 0 from the horizon on; exponent 0 gives 1 above it
    if (cosine <= 0.0) return 0.0;
    return exp(max(exponent * (cosine < 0.5 ? log(cosine) : log_one_less(below)), -200.0));
}
