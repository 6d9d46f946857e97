#include "optics/blinn_phong.glsl"
#include "optics/spherical.glsl"

// model 0: Phong as printed, 1: Phong as a BRDF, 2: Blinn-Phong as printed, 3: Blinn-Phong as a BRDF

float highlight_brdf(int model, float theta_l, float theta_v, float phi, float k_d, float k_s, float exponent) {
    // The Phong Model (1), The Blinn Model (1), Blinn-Phong BRDF (2)
    vec3 n = vec3(0.0, 0.0, 1.0), l = light_direction(theta_l, phi), v = view_direction(theta_v);
    if (model == 0) return brdf_phong_printed(n, l, v, k_d, k_s, exponent);
    if (model == 1) return brdf_phong(n, l, v, k_d, k_s, exponent);
    if (model == 2) return brdf_blinn_phong_printed(n, l, v, k_d, k_s, exponent);
    return brdf_blinn_phong(n, l, v, k_d, k_s, exponent);
}

float highlight_share(int model, float theta_l, float theta_v, float phi, float k_d, float k_s, float exponent) {
    // BRDF - The Reflectance Equation (3): L_o over the irradiance of a surface that faces the light
    vec3 n = vec3(0.0, 0.0, 1.0), l = light_direction(theta_l, phi), v = view_direction(theta_v);
    if (model == 0) return shading_phong(n, l, v, k_d, k_s, exponent);
    if (model == 1) return brdf_phong(n, l, v, k_d, k_s, exponent) * cos(theta_l);
    if (model == 2) return shading_blinn_phong(n, l, v, k_d, k_s, exponent);
    return brdf_blinn_phong(n, l, v, k_d, k_s, exponent) * cos(theta_l);
}

float highlight_peak(int model, float k_d, float k_s, float exponent) {
    // The largest value of the BRDF for light along the normal
    if (model == 0 || model == 2) return k_d + k_s;
    return k_d / PI + k_s * (model == 1 ? normalisation_phong(exponent) : normalisation_blinn_phong(exponent));
}

float highlight_flux(int model, float theta_l, float k_d, float k_s, float exponent) {
    // The Importance of Being Normalized (1): what leaves over what arrives
    if (model == 0) return PI * k_d + k_s * lobe_flux_phong(theta_l, exponent) / cos(theta_l);
    if (model == 1) return k_d + k_s * albedo_phong(theta_l, exponent);
    if (model == 2) return PI * k_d + k_s * lobe_flux_blinn(theta_l, exponent) / cos(theta_l);
    return k_d + k_s * albedo_blinn_phong(theta_l, exponent);
}
