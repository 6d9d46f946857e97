#include "core/constants.glsl"
#include "optics/facets.glsl"
#include "optics/fresnel.glsl"
#include "optics/geometry_term.glsl"

float schlick_at(float theta_l, float theta_v, float phi, float f0) {
    // Fresnel Term (1): F at l.h
    return f_schlick(half_cosines(theta_l, theta_v, phi).w, f0);
}

float dg_at(float theta_l, float theta_v, float phi, float m) {
    // Geometric Term (1): facets towards h that are not blocked
    return d_halfway(theta_l, theta_v, phi, m) * vgroove_at(theta_l, theta_v, phi);
}

float dgf_at(float theta_l, float theta_v, float phi, float m, float f0) {
    // The Cook - Torrance Model (2): the numerator
    return dg_at(theta_l, theta_v, phi, m) * schlick_at(theta_l, theta_v, phi, f0);
}

float mirror_gain(float theta, float f0) {
    // The Cook - Torrance Model (2), in the mirror direction over head-on
    float cosine = cos(theta);
    return f_schlick(cosine, f0) / (f0 * cosine * cosine);
}

float denominator(float n_dot_l, float n_dot_v) {
    // The Cook - Torrance Model (2), with 1/4
    return 4.0 * n_dot_l * n_dot_v;
}

float denominator_printed(float n_dot_l, float n_dot_v) {
    // The Cook - Torrance Model (2), as printed, with 1/pi
    return PI * n_dot_l * n_dot_v;
}
