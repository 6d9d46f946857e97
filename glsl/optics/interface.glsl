#include "core/constants.glsl"
#include "core/angle.glsl"
#include "optics/fresnel.glsl"

float reflected_share(float theta, float eta) {
    // Fresnel Term (2): unpolarised light, by its angle from the normal
    return f_dielectric(max(0.0, cos(theta)), eta);
}

float reflected_share_s(float theta, float eta) {
    // Fresnel 1823: polarised across the plane of incidence
    return f_dielectric_s(max(0.0, cos(theta)), eta);
}

float reflected_share_p(float theta, float eta) {
    // Fresnel 1823: polarised along the plane of incidence
    return f_dielectric_p(max(0.0, cos(theta)), eta);
}

float transmitted_share(float theta, float eta) {
    // Fresnel Term (1): what is not reflected enters
    return t_dielectric(max(0.0, cos(theta)), eta);
}

float both_shares(float theta, float eta) {
    // Fresnel Term (1): reflected and transmitted, two formulas
    return reflected_share(theta, eta) + transmitted_share(theta, eta);
}

float polarised_share(float theta, float eta, float polariser) {
    // Malus 1809: a polariser before the eye, at 0 it lets s through
    float c = cos(polariser), s = sin(polariser);
    return reflected_share_s(theta, eta) * c * c + reflected_share_p(theta, eta) * s * s;
}

float refracted_angle(float theta, float eta) {
    // Snell's law
    float angle = min(theta, 0.5 * PI);
    return arctan2(sin(angle), eta * refracted_cosine(max(0.0, cos(angle)), eta));
}

float schlick_share(float theta, float eta) {
    // Schlick 1994, from the index
    return f_schlick(max(0.0, cos(theta)), f0_from_eta(eta));
}

float f_average_schlick_eta(float eta) {
    // Schlick 1994, averaged over the hemisphere, from the index
    return f_average_schlick(f0_from_eta(eta));
}

float angle_of_half(float eta) {
    // Fresnel 1823: f_dielectric = 1/2, by halving the interval
    float low = 0.0, high = 1.0;
    for (int i = 0; i < 30; i++) {
        float middle = 0.5 * (low + high);
        if (f_dielectric(middle, eta) > 0.5) low = middle;
        else high = middle;
    }
    float c = 0.5 * (low + high);
    return arctan2(sqrt((1.0 - c) * (1.0 + c)), c) * (180.0 / PI);
}
