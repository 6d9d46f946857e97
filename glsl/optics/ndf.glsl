#include "core/constants.glsl"
#include "core/angle.glsl"
#include "core/gauss.glsl"
#include "core/power.glsl"
#include "optics/beckmann.glsl"
#include "optics/ggx.glsl"

float gauss_constant(float m) {
    // the integral of e^(-a^2 / m^2) cos a over the hemisphere; beyond 4.2 m there is nothing to float32
    m = max(m, SMOOTHEST);
    float end = min(0.5 * PI, 4.2 * m), sum = 0.0;
    for (int i = 0; i < 12; i++) {
        float a = end * GAUSS_X[i];
        sum += GAUSS_W[i] * exp(-(a / m) * (a / m)) * sin(2.0 * a);
    }
    return 1.0 / (PI * end * sum);
}

float d_gauss_slope(float slope2, float m) {
    // Distribution Term (1): Blinn 1977, with its own constant
    float x = arctan2(sqrt(slope2), 1.0) / max(m, SMOOTHEST), root = exp(-0.5 * x * x);
    return gauss_constant(m) * root * root;
}

float d_gauss(vec3 n, vec3 h, float m) {
    // Distribution Term (1): Blinn 1977, with its own constant; h of any length
    return dot(n, h) > 0.0 ? d_gauss_slope(slope_squared(n, h), m) : 0.0;
}

float d_blinn_phong_slope(float slope2, float exponent) {
    // Distribution Term (1): the cosine lobe with the constant of a facet distribution
    float cosine = 1.0 / sqrt(1.0 + slope2);
    float root = cosine_power(cosine, slope2 / (1.0 + slope2) / (1.0 + cosine), 0.5 * exponent);
    return (exponent + 2.0) / (2.0 * PI) * root * root;
}

float d_blinn_phong(vec3 n, vec3 h, float exponent) {
    // Distribution Term (1): the cosine lobe with the constant of a facet distribution; h of any length
    return dot(n, h) > 0.0 ? d_blinn_phong_slope(slope_squared(n, h), exponent) : 0.0;
}

float d_slope(int ndf, float slope2, float m) {
    // Distribution Term (1): 0 Gauss, 1 cosine lobe, 2 Beckmann, 3 GGX
    if (ndf == 0) return d_gauss_slope(slope2, m);
    if (ndf == 1) return d_blinn_phong_slope(slope2, exponent_from_m(min(m, 1.0)));
    return ndf == 2 ? d_beckmann_slope(slope2, m) : d_ggx_slope(slope2, m);
}

float d_at(int ndf, float theta_h, float m) {
    // Distribution Term (1): one of four, at an angle between n and h
    float t = sin(theta_h) / max(cos(theta_h), 1e-9);
    return d_slope(ndf, t * t, m);
}

float facet_area(int ndf, float m, int rows, int cosines) {
    // Distribution Term (1): D cos a in rings of equal height; sums of 64, then of those, as one long sum loses digits
    float sum = 0.0, da = 0.5 * PI / float(rows);
    for (int block = 0; block < rows; block += 64) {
        float part = 0.0;
        for (int i = block; i < min(block + 64, rows); i++) {
            float a = (float(i) + 0.5) * da;
            part += d_at(ndf, a, m) * (2.0 * PI * da * sin(a) * (cosines == 1 ? cos(a) : 1.0));
        }
        sum += part;
    }
    return sum;
}

float facet_area_of_lobe(float m) {
    // Blinn-Phong BRDF (1) in the place of Distribution Term (1): f_n is no constant for a D
    float n = exponent_from_m(min(m, 1.0));
    return 0.25 * (n + 4.0) / (n + exp2(-0.5 * n));
}

float d_lean(int ndf, float slope_ratio, float m) {
    // Distribution Term (1): one of four, at a slope in units of m
    return d_slope(ndf, slope_ratio * m * (slope_ratio * m), m);
}

vec3 leaning(float slope_ratio, float m) {
    // a facet's normal whose slope is given in units of m, the surface's being +z
    float x = slope_ratio * max(m, SMOOTHEST);
    return vec3(x, 0.0, 1.0) / sqrt(1.0 + x * x);
}

float d_beside(float slope_ratio, float m) {
    // Distribution Term (3), the stable form, through vectors
    return d_beckmann(vec3(0.0, 0.0, 1.0), leaning(slope_ratio, m), m);
}

float d_beside_naive(float slope_ratio, float m) {
    // Distribution Term (3), the fast form, through vectors
    return d_beckmann_naive(vec3(0.0, 0.0, 1.0), leaning(slope_ratio, m), m);
}

float d_beside_acos_naive(float slope_ratio, float m) {
    // Distribution Term (2), the expensive form, through vectors
    return d_beckmann_acos_naive(vec3(0.0, 0.0, 1.0), leaning(slope_ratio, m), m);
}

float cosine_steps(float slope_ratio, float m) {
    // IEEE 754: below 1 the numbers are 2^-24 apart
    float t = slope_ratio * m * (slope_ratio * m);
    return 16777216.0 * t / (1.0 + t + sqrt(1.0 + t));
}
