#include "core/constants.glsl"
#include "core/exponential.glsl"
#include "core/gauss.glsl"
#include "optics/beckmann.glsl"
#include "optics/facets.glsl"
#include "optics/ndf.glsl"

const float BALL_PIXELS = 600.0; // across the ball, where a formula needs to know

float m_effective(float m, float bump_slope) {
    // Olano and Baker 2010, LEAN Mapping: slope variances add; bump_slope is along one axis, m along both
    return sqrt(m * m + 2.0 * bump_slope * bump_slope);
}

float bump_kept(float bumps) {
    // A wave through a Gaussian as wide as a pixel
    float p = PI * bumps / BALL_PIXELS;
    return exp(-p * p / 6.0);
}

float m_pixel(float m, float bump_slope, float bumps) {
    // LEAN Mapping: what a pixel does not show of a bump, it makes roughness
    float p = PI * bumps / BALL_PIXELS;
    return m_effective(m, bump_slope * sqrt(one_less_exp(p * p / 3.0)));
}

float d_bumps(float m, float bump_slope) {
    // The Scale Effect: D(0), averaged over bumps of normal slopes, in closed form
    m = max(m, SMOOTHEST);
    float s = 2.0 * bump_slope * bump_slope, both = m * m + s, q = m * m / both * s;
    return (1.0 + 2.0 * q * (1.0 + q)) / (PI * both);
}

float d_bumps_counted(float theta_h, float m, float bump_slope, int facets) {
    // The Scale Effect: the mean of D over that many bumps, in parts, or equal terms round all the same way
    vec3 h = vec3(sin(theta_h), 0.0, cos(theta_h));
    float sum = 0.0, part = 0.0;
    for (int i = 0; i < facets; i++) {
        part += d_beckmann(facet_normal(i, 1.41421356 * bump_slope, facets), h, m);
        if (i % 64 == 63 || i == facets - 1) {
            sum += part;
            part = 0.0;
        }
    }
    return sum / float(facets);
}

float bumps_slope2(float theta_h) {
    // tan^2 of the angle between n and h
    float t = sin(theta_h) / max(cos(theta_h), 1e-9);
    return t * t;
}

float d_filtered(float theta_h, float m, float bump_slope) {
    // LEAN Mapping: one evaluation, with the roughness of facets and bumps together
    return d_beckmann_slope(bumps_slope2(theta_h), m_effective(m, bump_slope));
}

float d_unfiltered(float theta_h, float m) {
    // Distribution Term (2): the bumps forgotten
    return d_beckmann_slope(bumps_slope2(theta_h), m);
}

float normal_shortfall(float bump_slope) {
    // Toksvig 2005: 1 - the length of the mean normal of the bumps, as a mean of what each falls short
    float s = 2.0 * bump_slope * bump_slope, sum = 0.0;
    for (int i = 0; i < 36; i++) {
        float low = i < 12 ? 0.0 : i < 24 ? 1.5 : 3.0, wide = i < 24 ? 1.5 : 3.5;
        float x = low + wide * GAUSS_X[i % 12], t = s * x * x, w = sqrt(1.0 + t);
        sum += wide * GAUSS_W[i % 12] * 2.0 * x * exp(-x * x) * t / (w * (1.0 + w));
    }
    return sum;
}

float d_toksvig(float theta_h, float m, float bump_slope) {
    // Toksvig 2005, Mipmapping Normal Maps: shorter mean normals, wider highlights
    float e = exponent_from_m(min(m, 1.0)), gap = normal_shortfall(bump_slope), length_ = 1.0 - gap;
    return d_blinn_phong_slope(bumps_slope2(theta_h), e * length_ / (length_ + e * gap));
}

float aliasing_error(float m, float bump_slope) {
    // The Scale Effect: sqrt(E[D^2] / E[D]^2 - 1) of one bump for all, taken apart so that nothing cancels
    m = max(m, SMOOTHEST);
    float mm = m * m, s = 2.0 * bump_slope * bump_slope, q = mm / (mm + s) * s, p = mm / (mm + 2.0 * s) * s;
    float less = q / (mm + 2.0 * s) * s, mean = 1.0 + 2.0 * q * (1.0 + q);
    float square = 1.0 + p * (4.0 + p * (12.0 + p * (24.0 + p * 24.0)));
    float rest = -4.0 * less + (12.0 * p * p - 8.0 * q * q) + (24.0 * p * p * p - 8.0 * q * q * q) + (24.0 * p * p * p * p - 4.0 * q * q * q * q);
    float spread = s / mm * (s / (mm + 2.0 * s));
    return sqrt(max((spread * square + rest) / (mean * mean), 0.0));
}

float sampling_error(int samples, float m, float bump_slope) {
    // The variance of a mean
    return aliasing_error(m, bump_slope) / sqrt(float(samples));
}

float filter_error(float m, float bump_slope) {
    // LEAN Mapping: 1 - d_filtered(0) / d_bumps
    m = max(m, SMOOTHEST);
    float s = 2.0 * bump_slope * bump_slope, q = m * m / (m * m + s) * s, more = 2.0 * q * (1.0 + q);
    return more / (1.0 + more);
}

float samples_worth(float m, float bump_slope) {
    // sampling_error = filter_error
    float ratio = aliasing_error(m, bump_slope) / filter_error(m, bump_slope);
    return ratio * ratio;
}
