#include "optics/phong.glsl"

vec3 halfway(vec3 l, vec3 v) {
    // The Blinn Model (2): 0 for opposite directions, which have none
    vec3 s = l + v;
    float size = length(s);
    return size > 0.0 ? s / size : vec3(0.0);
}

float halfway_cosine(vec3 n, vec3 l, vec3 v) {
    // The Blinn Model (1): n.h, for l and v of any length
    vec3 s = l * length(v) + v * length(l);
    float size = length(s);
    return size > 0.0 ? dot(n, s) / size : 0.0;
}

float lobe_blinn(vec3 n, vec3 l, vec3 v, float exponent) {
    // Blinn 1977: (n.h)^exponent; 1 - n.h = |n - h|^2 / 2 keeps its digits near the normal
    vec3 h = halfway(l, v), off = n - h;
    return cosine_power(dot(n, h), 0.5 * dot(off, off), exponent);
}

float lobe_blinn_naive(vec3 n, vec3 l, vec3 v, float exponent) {
    // The Blinn Model (1), literally: the power of a number next to 1
    float n_dot_h = dot(n, halfway(l, v));
    return n_dot_h > 0.0 ? pow(n_dot_h, exponent) : 0.0;
}

float shading_blinn_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // The Blinn Model (1), as printed: L_o / L_i
    float n_dot_l = dot(n, l);
    return n_dot_l > 0.0 ? k_d * n_dot_l + k_s * lobe_blinn(n, l, v, exponent) : 0.0;
}

float brdf_blinn_phong_printed(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // Is the Phong-Blinn Model Realistic? What the printed formula is as a BRDF
    float n_dot_l = dot(n, l);
    return n_dot_l > 0.0 && dot(n, v) > 0.0 ? k_d + k_s * lobe_blinn(n, l, v, exponent) / n_dot_l : 0.0;
}

float normalisation_blinn_phong(float exponent) {
    // Blinn-Phong BRDF (1)
    float e = exponent;
    return (e + 2.0) * (e + 4.0) / (8.0 * PI * (e + exp2(-0.5 * e)));
}

float normalisation_short(float exponent, float summand) {
    // Akenine-Moller et al. 2008, Real-Time Rendering, and others: short cuts
    return (exponent + summand) / (8.0 * PI);
}

float normalisation_short_share(float exponent, float summand) {
    // The Importance of Being Normalized (1): what a short cut gives back along the normal
    return normalisation_short(exponent, summand) / normalisation_blinn_phong(exponent);
}

float brdf_blinn_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // Blinn-Phong BRDF (2)
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0) return 0.0;
    return k_d / PI + k_s * normalisation_blinn_phong(exponent) * lobe_blinn(n, l, v, exponent);
}

float lobe_flux_blinn(float theta_v, float exponent) {
    // Torrance and Sparrow 1967, dw_l = 4 l.h dw_h: azimuth in closed form, Gauss-Legendre in the angle of h
    float n_dot_v = cos(theta_v), s = sin(theta_v), sum = 0.0, low = 0.0;
    float top = 0.25 * PI + 0.5 * theta_v, edge = max(0.25 * PI - 0.5 * theta_v, 0.0);
    for (int piece = 0; piece < 10; piece++) {
        float high = quadrature_end(piece, edge, top, inversesqrt(exponent + 2.0)), size = high - low, part = 0.0;
        int count = size > 0.0 ? 24 : 0; // no constant: a compiler would write out all rounds
        for (int i = 0; i < count; i++) {
            float turn = 0.5 * PI * LEGENDRE_X[i], x = sin(turn), a = low + size * x * x, c = cos(a);
            float big_a = n_dot_v * c, big_b = s * sin(a);
            float inner = big_b > 0.0 ? clamp((n_dot_v / (2.0 * c) - big_a) / big_b, -1.0, 1.0) : -1.0;
            float turned = arccos(inner), sine = sqrt((1.0 - inner) * (1.0 + inner));
            float i1 = big_a * turned + big_b * sine;
            float i2 = big_a * (i1 + big_b * sine) + 0.5 * big_b * big_b * (turned + sine * inner);
            part += LEGENDRE_W[i] * x * cos(turn) * sin(a) * cosine_lobe(a, exponent) * (2.0 * c * i2 - n_dot_v * i1);
        }
        sum += size * part;
        low = max(low, high);
    }
    return 8.0 * PI * sum;
}

float albedo_blinn_phong(float theta_v, float exponent) {
    // Blinn-Phong BRDF (1): 1 at the normal, cos^2 theta_v for large exponents
    return normalisation_blinn_phong(exponent) * lobe_flux_blinn(theta_v, exponent);
}

float albedo_blinn_phong_limit(float theta_v) {
    // Blinn-Phong BRDF (1), for an exponent without end
    float c = cos(theta_v);
    return c * c;
}

float half_width_blinn(float exponent) {
    // Fisher and Woo 1994, R.E versus N.H Specular Highlights
    return 2.0 * half_width_phong(exponent);
}

float blinn_exponent(float exponent) {
    // Fisher and Woo 1994: as wide as a Phong highlight, in the plane of incidence
    return 1.38629436112 / -log_one_less(0.5 * one_less_exp(0.69314718056 / max(exponent, 1e-30)));
}

float blinn_exponent_short(float exponent) {
    // Fisher and Woo 1994: the rule of thumb
    return 4.0 * exponent;
}

float brdf_blinn_phong_as_wide(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    // Blinn-Phong BRDF (2), its highlight as wide as Phong's of this exponent
    return brdf_blinn_phong(n, l, v, k_d, k_s, blinn_exponent(exponent));
}

float highlight_stretch(float theta_v) {
    // Ngan, Durand and Matusik 2005, Experimental Analysis of BRDF Models
    return 1.0 / cos(theta_v);
}

vec3 sample_blinn_phong(float xi_1, float xi_2, float exponent) {
    // Walter 2005, Notes on the Ward BRDF: a facet h drawn with (n.h)^(exponent + 1)
    float log_cosine = log_one_less(min(xi_1, 0.99999994)) / (exponent + 2.0), turn = 2.0 * PI * xi_2;
    float sine = sqrt(one_less_exp(-2.0 * log_cosine));
    return vec3(sine * cos(turn), sine * sin(turn), exp(log_cosine));
}

float pdf_blinn_phong(vec3 n, vec3 l, vec3 v, float exponent) {
    // Walter 2005: the density of h over 4 l.h
    float l_dot_h = dot(l, halfway(l, v));
    if (l_dot_h <= 0.0) return 0.0;
    return (exponent + 2.0) / (8.0 * PI * l_dot_h) * lobe_blinn(n, l, v, exponent + 1.0);
}
