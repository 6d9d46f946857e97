#include "core/constants.glsl"
#include "core/angle.glsl"
#include "optics/radiometry.glsl"
#include "optics/photometry.glsl"
#include "optics/projected_solid_angle.glsl"

float bulb_luminous_intensity(float electrical_power, float source_efficacy) {
    // Units for Lighting - Candela: flux over 4 pi
    return luminous_flux_source(electrical_power, source_efficacy) / (4.0 * PI);
}

float bulb_illuminance(float electrical_power, float source_efficacy, float distance) {
    // Units for Lighting - Candela: I / r^2
    return illuminance_isotropic(luminous_flux_source(electrical_power, source_efficacy), distance, 0.0);
}

float bulb_luminance(float electrical_power, float source_efficacy, float distance, float rho) {
    // Lambert 1760: rho E / pi
    return luminance_lambert(rho, bulb_illuminance(electrical_power, source_efficacy, distance));
}

float bulb_radiant_flux(float electrical_power, float radiated_share) {
    // Units for Lighting - Watts: produced, not consumed
    return electrical_power * radiated_share;
}

float bulb_radiant_intensity(float electrical_power, float radiated_share) {
    // Measuring Light: Phi / 4 pi
    return radiant_intensity_isotropic(bulb_radiant_flux(electrical_power, radiated_share));
}

float bulb_irradiance(float electrical_power, float radiated_share, float distance) {
    // Measuring Light: I / r^2
    return irradiance_isotropic(bulb_radiant_flux(electrical_power, radiated_share), distance);
}

float bulb_radiance(float electrical_power, float radiated_share, float distance, float rho) {
    // Lambert 1760: rho E / pi
    return radiance_lambert(rho, bulb_irradiance(electrical_power, radiated_share, distance));
}

float bulb_received(float electrical_power, float source_efficacy, float radius, float distance) {
    // Basic Radiometric Quantities (3): the illuminance integrated over the table, ring by ring
    float rim = arctan2(radius, distance), total = 0.0;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 8; j++) {
            float a = rim * (float(i) + GAUSS_AT[j]) / 4.0, q = distance * tan(a);
            float dq = 0.25 * rim * GAUSS_WEIGHT[j] * distance / (cos(a) * cos(a));
            total += irradiance_point(1.0, length(vec2(q, distance)), a) * 2.0 * PI * q * dq;
        }
    }
    return bulb_luminous_intensity(electrical_power, source_efficacy) * total;
}

float bulb_escaped(float electrical_power, float source_efficacy, float radius, float distance) {
    // Units for Lighting - Candela: the intensity integrated over the directions beyond the rim
    float rim = arctan2(radius, distance), total = 0.0;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 8; j++) {
            float a = rim + (PI - rim) * (float(i) + GAUSS_AT[j]) / 4.0;
            total += 2.0 * PI * sin(a) * GAUSS_WEIGHT[j] * 0.25 * (PI - rim);
        }
    }
    return bulb_luminous_intensity(electrical_power, source_efficacy) * total;
}
