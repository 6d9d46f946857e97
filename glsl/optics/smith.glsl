float lambda_beckmann_slope(float slope) {
    // Smith 1967, Geometrical Shadowing of a Random Rough Surface. e^(-a^2) (1 - sqrt(pi) a erfcx(a)) / (2 a sqrt(pi)),
    // a = 1 / slope; the bracket over t^2, t = 1 / (1 + a/2), is a polynomial fitted here: 5e-8, nothing cancels
    if (slope < 0.075) return 0.0; // below the smallest float
    float a = 1.0 / slope, t = 1.0 / (1.0 + 0.5 * a);
    float q = 0.12498994 + t * (0.25031790 + t * (0.32397252 + t * (0.34153652 + t * (0.06935966 + t * (0.23908611
        + t * (-0.33876920 + t * (-0.69207484 + t * (1.25955367 + t * (-0.72961015 + t * 0.15163781)))))))));
    return exp(-a * a) * slope * t * t * q * 0.282094792; // 1 / (2 sqrt(pi))
}

float lambda_beckmann_slope_naive(float slope) {
    // Walter et al. 2007, the fit, with a = m tan theta: its quotient read upside down
    float a = max(slope, 1e-6);
    return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
}

float lambda_beckmann(float n_dot_v, float m) {
    // Smith 1967
    float c = clamp(n_dot_v, 1e-30, 1.0);
    return lambda_beckmann_slope(m * sqrt((1.0 - c) * (1.0 + c)) / c);
}

float lambda_ggx_slope(float slope) {
    // Walter et al. 2007, Microfacet Models for Refraction; without the difference sqrt(1 + x^2) - 1
    return slope > 1e8 ? 0.5 * slope : 0.5 * slope * (slope / (1.0 + sqrt(1.0 + slope * slope)));
}

float lambda_ggx(float n_dot_v, float alpha) {
    // Walter et al. 2007
    float c = clamp(n_dot_v, 1e-30, 1.0);
    return lambda_ggx_slope(alpha * sqrt((1.0 - c) * (1.0 + c)) / c);
}

float g1_beckmann(float n_dot_v, float m) {
    // Smith 1967
    return 1.0 / (1.0 + lambda_beckmann(n_dot_v, m));
}

float g1_ggx(float n_dot_v, float alpha) {
    // Walter et al. 2007
    return 1.0 / (1.0 + lambda_ggx(n_dot_v, alpha));
}

float g1_beckmann_rational(float n_dot_v, float m) {
    // Walter et al. 2007, equation 27, a fit: off by up to .0031, and above 1 just below a = 1.6
    float c = clamp(n_dot_v, 1e-30, 1.0), x = m * sqrt((1.0 - c) * (1.0 + c)) / c;
    if (1.6 * x <= 1.0) return 1.0;
    return (3.535 + 2.181 / x) / (x + 2.276 + 2.577 / x);
}

float g_smith_separable(float n_dot_v, float n_dot_l, float m) {
    // Smith 1967; Walter et al. 2007: lit and seen as if independent
    return g1_beckmann(n_dot_v, m) * g1_beckmann(n_dot_l, m);
}

float g_smith_correlated(float n_dot_v, float n_dot_l, float m) {
    // Heitz 2014, Understanding the Masking-Shadowing Function: what lies high is lit and seen
    return 1.0 / (1.0 + lambda_beckmann(n_dot_v, m) + lambda_beckmann(n_dot_l, m));
}

float g_smith_separable_ggx(float n_dot_v, float n_dot_l, float alpha) {
    // Walter et al. 2007
    return g1_ggx(n_dot_v, alpha) * g1_ggx(n_dot_l, alpha);
}

float g_smith_correlated_ggx(float n_dot_v, float n_dot_l, float alpha) {
    // Heitz 2014
    return 1.0 / (1.0 + lambda_ggx(n_dot_v, alpha) + lambda_ggx(n_dot_l, alpha));
}
