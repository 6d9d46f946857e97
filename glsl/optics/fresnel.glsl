#include "core/constants.glsl"
#include "core/angle.glsl"
#include "core/legendre.glsl"

// eta: index of the far side over that of the near side. l_dot_h: the cosine at the facet.

float far_cosine_squared(float l_dot_h, float eta) {
    // Snell's law: (eta times the cosine on the far side)^2 without cancellation; negative: total reflection
    float c = l_dot_h;
    return eta < 1.0 ? eta * eta - (1.0 - c) * (1.0 + c) : (eta - 1.0) * (eta + 1.0) + c * c;
}

float f_dielectric_s(float l_dot_h, float eta) {
    // Fresnel 1823, polarised across the plane of incidence; rationalised, so that only eta - 1 is a difference
    float c = l_dot_h, q = (eta - 1.0) * (eta + 1.0), g2 = far_cosine_squared(c, eta);
    if (g2 <= 0.0) return 1.0;
    float g = sqrt(g2), sum = c + g, least = min(c, g);
    float r = 4.0 * least < sum ? 1.0 - 2.0 * least / sum : q / (sum * sum); // both are |c - g| / (c + g)
    return r * r;
}

float f_dielectric_p(float l_dot_h, float eta) {
    // Fresnel 1823, polarised along the plane of incidence; 0 at Brewster's angle
    float c = l_dot_h, q = (eta - 1.0) * (eta + 1.0), g2 = far_cosine_squared(c, eta);
    if (g2 <= 0.0) return 1.0;
    float ec2 = eta * eta * c * c, zero = eta < 1.0 ? ec2 - (1.0 - c) * (1.0 + c) : ec2 + c * c - 1.0;
    float far = eta * eta * c, g = sqrt(g2), sum = far + g, least = min(far, g);
    float r = 4.0 * least < sum ? 1.0 - 2.0 * least / sum : q * zero / (sum * sum);
    return r * r;
}

float f_dielectric(float l_dot_h, float eta) {
    // Fresnel 1823, unpolarised light on a transparent medium
    return 0.5 * (f_dielectric_s(l_dot_h, eta) + f_dielectric_p(l_dot_h, eta));
}

float f_dielectric_naive(float l_dot_h, float eta) {
    // Fresnel 1823 with Snell's law: the root of a negative number in total reflection
    float c = l_dot_h, g = sqrt(1.0 - (1.0 - c * c) / (eta * eta));
    float s = (c - eta * g) / (c + eta * g), p = (eta * c - g) / (eta * c + g);
    return 0.5 * (s * s + p * p);
}

float t_dielectric(float l_dot_h, float eta) {
    // Fresnel 1823: the share that enters; a product, where 1 - F would cancel
    float c = l_dot_h, g2 = far_cosine_squared(c, eta);
    if (g2 <= 0.0) return 0.0;
    float g = sqrt(g2), near = c + g, far = eta * eta * c + g;
    return 2.0 * c * g * (1.0 / (near * near) + (eta / far) * (eta / far));
}

float f_conductor(float l_dot_h, float eta, float k) {
    // Lagarde 2013, Memo on Fresnel Equations: the complex index eta + i k in real numbers
    float c = l_dot_h, s2 = (1.0 - c) * (1.0 + c), t0 = (eta - k) * (eta + k) - s2, r = length(vec2(t0, 2.0 * eta * k));
    float root = sqrt(0.5 * (r + abs(t0)));
    float a = t0 >= 0.0 ? root : root > 0.0 ? eta * k / root : 0.0;
    float t1 = r + c * c, t2 = 2.0 * a * c, t3 = c * c * r + s2 * s2, t4 = t2 * s2;
    float r_s = t1 + t2 > 0.0 ? (t1 - t2) / (t1 + t2) : 1.0;
    float ratio = t3 + t4 > 0.0 ? (t3 - t4) / (t3 + t4) : 1.0;
    return 0.5 * r_s * (1.0 + ratio);
}

float f_conductor_naive(float l_dot_h, float eta, float k) {
    // Fresnel 1823 with the real part of the index alone, as if the metal were a glass
    return f_dielectric(l_dot_h, eta);
}

float f_schlick(float l_dot_h, float f0) {
    // Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
    float x = max(0.0, 1.0 - l_dot_h), x2 = x * x;
    return f0 + (1.0 - f0) * x2 * x2 * x;
}

float f_f82(float l_dot_h, float f0, float f82) {
    // Hoffman 2019, Fresnel Equations Considered Harmful: Schlick, bent through a second point at l_dot_h = 1/7
    float c = min(1.0, l_dot_h), x = 1.0 - c, x3 = x * x * x;
    float b = (f_schlick(1.0 / 7.0, f0) - f82) * 17.6513846021948; // 7 (7/6)^6
    return f_schlick(c, f0) - b * c * x3 * x3;
}

float f0_from_eta(float eta) {
    // Fresnel 1823 at normal incidence
    float r = (eta - 1.0) / (eta + 1.0);
    return r * r;
}

float eta_from_f0(float f0) {
    // Fresnel 1823 at normal incidence, solved for the index above 1
    float r = 1.0 + sqrt(f0);
    return r * r / (1.0 - f0);
}

float brewster_angle(float eta) {
    // Brewster 1815
    return arctan2(eta, 1.0);
}

float critical_angle(float eta) {
    // Snell's law: the refracted ray runs along the boundary
    float e = min(eta, 1.0);
    return arctan2(e, sqrt((1.0 - e) * (1.0 + e)));
}

float refracted_cosine(float l_dot_h, float eta) {
    // Snell's law
    return sqrt(max(0.0, far_cosine_squared(l_dot_h, eta))) / eta;
}

float f_average_schlick(float f0) {
    // Schlick 1994, averaged over the cosine-weighted hemisphere
    return f0 + (1.0 - f0) / 21.0;
}

float f_average_dielectric(float eta) {
    // Walsh 1926: 2 int F mu dmu; the s part in closed form, the p part in u with mu = sqrt(q) sinh(u)
    float n = max(eta, 1.0 / eta), q = (n - 1.0) * (n + 1.0), s = (n - 1.0) * (3.0 * n + 1.0) / (3.0 * (n + 1.0) * (n + 1.0)), p = 0.0;
    if (n == 1.0) return 0.0;
    float top = 0.5 * log((n + 1.0) / (n - 1.0)), wide = sqrt(q);
    for (int i = 0; i < 24; i++) {
        float v = LEGENDRE_X[i], c = wide * sinh(top * v * v), g = wide * cosh(top * v * v), sum = n * n * c + g;
        float r = q * ((n * n + 1.0) * c * c - 1.0) / (sum * sum);
        p += 2.0 * r * r * c * g * 2.0 * top * v * LEGENDRE_W[i];
    }
    float outside = 0.5 * (s + p);
    return eta < 1.0 ? 1.0 - (1.0 - outside) / (n * n) : outside;
}
