#include "core/angle.glsl"
#include "optics/spherical.glsl"

const float EON_C1 = 0.28779340921; // 1/2 - 2/(3 pi)
const float EON_C2 = 0.07248821245; // 2/3 - 28/(15 pi)

float fon_loss(float n_dot_v) {
    // Portsmouth, Kutz and Hill 2025: 1 - E but for K r / pi, without a difference of nearly equal terms
    float mu = min(n_dot_v, 1.0), s = sqrt((1.0 - mu) * (1.0 + mu));
    float steep = PI * EON_C1 * mu * mu / (1.0 + s) + s * arctan2(mu, s) + s * s * mu;
    return steep - 2.0 / 3.0 * s * mu * (1.0 + s + s * s) / (1.0 + s);
}

float albedo_fon(float n_dot_v, float roughness) {
    // Portsmouth, Kutz and Hill 2025: the first bounce alone
    return 1.0 - roughness / (1.0 + EON_C1 * roughness) * fon_loss(n_dot_v) / PI;
}

float eon_rho_again(float rho, float roughness) {
    // Portsmouth, Kutz and Hill 2025: what comes out after more than one bounce
    float lost = roughness * (EON_C1 - EON_C2) / (1.0 + EON_C1 * roughness);
    return rho * rho * (1.0 - lost) / (1.0 - rho * lost);
}

float albedo_eon(float n_dot_v, float rho, float roughness) {
    // Portsmouth, Kutz and Hill 2025: 1 for rho = 1
    float first = albedo_fon(n_dot_v, roughness);
    return rho * first + eon_rho_again(rho, roughness) * (1.0 - first);
}

float brdf_eon(vec3 n, vec3 l, vec3 v, float rho, float roughness) {
    // Portsmouth, Kutz and Hill 2025, EON: A practical energy-preserving rough diffuse BRDF
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    if (n_dot_l <= 0.0 || n_dot_v <= 0.0) return 0.0;
    float s = dot(l - n_dot_l * n, v - n_dot_v * n), k = 1.0 / (1.0 + EON_C1 * roughness);
    float first = rho * (1.0 + roughness * s / (s > 0.0 ? max(n_dot_l, n_dot_v) : 1.0));
    float lost = fon_loss(n_dot_l) * fon_loss(n_dot_v) / (PI * PI * (EON_C1 - EON_C2));
    return k / PI * (first + eon_rho_again(rho, roughness) * roughness * lost);
}

float brdf_eon_at(float theta_l, float theta_v, float phi, float rho, float roughness) {
    // Portsmouth, Kutz and Hill 2025, at angles
    return brdf_eon(vec3(0.0, 0.0, 1.0), light_direction(theta_l, phi), view_direction(theta_v), rho, roughness);
}
