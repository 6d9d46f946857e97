// The built-in log errs by up to 6e-7 near 1 (Mesa), where the logarithm itself is small.

float cosine_power(float cosine, float below, float exponent) {
    // cosine^exponent from the cosine and what it is below 1, 0 from the horizon on; exponent 0 gives 1 above it.
    // log(1 - below) is the odd series of z; below a half the built-in
    if (cosine <= 0.0) return 0.0;
    float z = -below / (2.0 - below), q = z * z;
    float series = 2.0 * z * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0 + q * (1.0 / 11.0 + q / 13.0))))));
    return exp(max(exponent * (cosine < 0.5 ? log(cosine) : series), -200.0));
}
