#include "core/power.glsl"
#include "core/angle.glsl"
#include "core/legendre.glsl"
#include "core/exponential.glsl"

vec3 reflection_vector(vec3 n, vec3 l) {
    // Phong Model: The Reflection Vector
    return 2.0 * dot(n, l) * n - l;
}

float mirror_cosine(vec3 n, vec3 l, vec3 v) {
    // The Phong Model (1): r.v, for l and v of any length
    vec3 r = reflection_vector(n, l);
    return dot(r, v) / sqrt(dot(r, r) * dot(v, v));
}

float cosine_lobe(float theta, float exponent) {
    // The Phong Model (3): cos^exponent from the angle; 1 - cos theta = 2 sin^2(theta / 2)
    if (abs(theta) >= 0.5 * PI) return 0.0;
    float s = sin(0.5 * theta);
    return cosine_power(cos(theta), 2.0 * s * s, exponent);
}

float lobe_phong(vec3 n, vec3 l, vec3 v, float exponent) {
    // Phong 1975: (r.v)^exponent; 1 - r.v = |r - v|^2 / 2 keeps its digits near the mirror direction
    vec3 r = reflection_vector(n, l), off = r - v;
    return cosine_power(dot(r, v), 0.5 * dot(off, off), exponent);
}

float lobe_phong_naive(vec3 n, vec3 l, vec3 v, float exponent) {
    // The Phong Model (1), literally, as a card takes a power: of a number next to 1, or of one below 0, which has no log
    return exp2(exponent * log2(dot(reflection_vector(n, l), v)));
}

float shading_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // The Phong Model (1), as printed: L_o / L_i
    float n_dot_l = dot(n, l);
    return n_dot_l > 0.0 ? k_d * n_dot_l + k_s * lobe_phong(n, l, v, exponent) : 0.0;
}

float brdf_phong_printed(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // Lewis 1994, Making Shaders More Physically Plausible: what the printed formula is as a BRDF
    float n_dot_l = dot(n, l);
    return n_dot_l > 0.0 && dot(n, v) > 0.0 ? k_d + k_s * lobe_phong(n, l, v, exponent) / n_dot_l : 0.0;
}

float normalisation_phong(float exponent) {
    // Lafortune and Willems 1994: 1 / int cos^(exponent + 1) dw
    return (exponent + 2.0) / (2.0 * PI);
}

float brdf_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // Lafortune and Willems 1994, Using the Modified Phong Reflectance Model
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0) return 0.0;
    return k_d / PI + k_s * normalisation_phong(exponent) * lobe_phong(n, l, v, exponent);
}

float lobe_flux_phong(float theta_v, float exponent) {
    // Arvo 1995, Applications of Irradiance Tensors: azimuth in closed form, Gauss-Legendre in the angle from v
    float c = cos(theta_v), s = sin(theta_v), sum = 0.0, edge = max(0.5 * PI - theta_v, 0.0), low = 0.0;
    for (int piece = 0; piece < 10; piece++) {
        float high = quadrature_end(piece, edge, 0.5 * PI, inversesqrt(exponent + 1.0)), size = high - low, part = 0.0;
        int count = size > 0.0 ? 24 : 0; // no constant: a compiler would write out all rounds
        for (int i = 0; i < count; i++) {
            float turn = 0.5 * PI * LEGENDRE_X[i], x = sin(turn), a = low + size * x * x;
            float big_a = c * cos(a), big_b = s * sin(a);
            float turned = arccos(big_b > 0.0 ? clamp(-big_a / big_b, -1.0, 1.0) : -1.0);
            float inside = big_a * turned + big_b * sin(turned);
            part += LEGENDRE_W[i] * x * cos(turn) * cosine_lobe(a, exponent) * sin(a) * inside;
        }
        sum += size * part;
        low = max(low, high);
    }
    return 2.0 * PI * sum;
}

float albedo_phong(float theta_v, float exponent) {
    // Lafortune and Willems 1994: 1 at the normal, cos theta_v for large exponents
    return normalisation_phong(exponent) * lobe_flux_phong(theta_v, exponent);
}

float half_width_phong(float exponent) {
    // The Phong Model (3): arccos 2^(-1 / exponent)
    float below = one_less_exp(0.69314718056 / max(exponent, 1e-30));
    return 2.0 * arctan2(sqrt(below), sqrt(2.0 - below));
}
