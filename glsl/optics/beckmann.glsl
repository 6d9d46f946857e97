#include "core/constants.glsl"
#include "core/exponential.glsl"

const float STEEPEST = 1e18; // slope2 of a facet on edge
const float SMOOTHEST = 1e-5; // a smaller m or width is taken as this: a mirror to two seconds of arc

float slope_squared(vec3 n, vec3 h) {
    // Distribution Term (3): tan^2 a, by the cross product; h of any length
    vec3 across = cross(n, h);
    float along = dot(n, h);
    return along > 0.0 ? min(dot(across, across) / (along * along), STEEPEST) : STEEPEST;
}

float d_beckmann_slope(float slope2, float m) {
    // Distribution Term (2): Beckmann and Spizzichino 1963; half of the exponent twice, so that nothing leaves the range
    m = max(m, SMOOTHEST);
    float k = 1.0 / (m * m), root = exp(-0.5 * k * slope2) * (1.0 + slope2);
    return root * (k / PI) * root;
}

float d_beckmann(vec3 n, vec3 h, float m) {
    // Distribution Term (2): Beckmann and Spizzichino 1963, stable for every m; h of any length
    return dot(n, h) > 0.0 ? d_beckmann_slope(slope_squared(n, h), m) : 0.0;
}

float d_beckmann_naive(vec3 n, vec3 h, float m) {
    // Distribution Term (3): the fast form; 1 - cos^2 a cancels
    float c = dot(n, h), c2 = c * c;
    m = max(m, SMOOTHEST);
    return c > 0.0 ? exp(min(-(1.0 - c2) / c2 / (m * m), 80.0)) / (PI * m * m * c2 * c2) : 0.0;
}

float d_beckmann_acos_naive(vec3 n, vec3 h, float m) {
    // Distribution Term (2): the expensive form
    float c = dot(n, h);
    if (c <= 0.0) return 0.0;
    m = max(m, SMOOTHEST);
    float a = acos(min(c, 1.0)), x = tan(a) / m, c2 = cos(a) * cos(a);
    return exp(-x * x) / (PI * m * m * c2 * c2);
}

float d_beckmann_printed(float theta_h, float m) {
    // Distribution Term (3), as printed: the minus is missing; held where the curve has left every page
    m = max(m, SMOOTHEST);
    float c = max(cos(theta_h), 1e-4), x = sin(theta_h) / c / m, c2 = c * c;
    return exp(min(x * x, 80.0)) / (PI * m * m * c2 * c2);
}

float beckmann_tail(float theta_h, float m) {
    // the integral of D cos a beyond an angle, in closed form
    float x = sin(theta_h) / max(cos(theta_h), 1e-9) / max(m, SMOOTHEST);
    return exp(-x * x);
}

float beckmann_within(float theta_h, float m) {
    // the integral of D cos a up to an angle, in closed form
    float x = sin(theta_h) / max(cos(theta_h), 1e-9) / max(m, SMOOTHEST);
    return one_less_exp(x * x);
}

float exponent_from_m(float m) {
    // Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces: lobes of equal width
    m = max(m, SMOOTHEST);
    return 2.0 * ((1.0 - m) / m) * ((1.0 + m) / m);
}

float m_from_exponent(float exponent) {
    // Walter et al. 2007, solved for m
    return sqrt(2.0 / (exponent + 2.0));
}

vec3 sample_beckmann(float xi_1, float xi_2, float m) {
    // Walter et al. 2007: tan^2 a = -m^2 log(1 - xi_1); the built-in log errs near 1, there its odd series
    float t = min(xi_1, 0.99999994);
    float z = t / (2.0 - t), q = z * z;
    float series = 2.0 * z * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0 + q * (1.0 / 11.0 + q / 13.0))))));
    float slope = max(m, SMOOTHEST) * sqrt(t < 0.5 ? series : -log(1.0 - t));
    return vec3(slope * cos(2.0 * PI * xi_2), slope * sin(2.0 * PI * xi_2), 1.0) / sqrt(1.0 + slope * slope);
}

float pdf_beckmann(vec3 n, vec3 l, vec3 v, float m) {
    // Walter et al. 2007: D (n.h) / (4 l.h), both from l + v
    vec3 both = l + v;
    float along = dot(n, both);
    return along > 0.0 ? d_beckmann(n, both, m) * along / (2.0 * dot(both, both)) : 0.0;
}
