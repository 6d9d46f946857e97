#include "optics/colour.glsl"
#include "optics/photometry.glsl"

// curve 0: cut at 1; 1: Reinhard; 2: Narkowicz's fit to ACES

const float SATURATION = 1.2; // ISO 12232:2006: 0.78 lx s, of a lens 0.65

float exposure_value(float luminance) {
    // ISO 2720:1974, K = 12.5
    return log2(8.0 * luminance);
}

float luminance_white(float ev100) {
    // ISO 12232:2006; Lagarde and de Rousiers 2014
    return SATURATION * exp2(ev100);
}

float exposed_luminance(float luminance, float ev100) {
    // 1 where the sensor is just full
    return luminance / luminance_white(ev100);
}

float tone_curve(float scene_linear, int curve) {
    // Reinhard et al. 2002; Narkowicz 2015
    float x = scene_linear;
    if (curve == 0) return min(x, 1.0);
    if (curve == 1) return x / (1.0 + x);
    return min(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

float stored_number(float linear) {
    // IEC 61966-2-1, 8 bits
    return 255.0 * linear_to_srgb(linear);
}

float stops(float gain) {
    // ISO 2720:1974: 1 EV halves the light
    return log2(gain);
}

float card_luminance(float luminous_flux, float distance, float rho) {
    // Working with Shading Models: lm, cd, lx, cd/m^2
    return luminance_lambert(rho, illuminance_isotropic(luminous_flux, distance, 0.0));
}

float card_exposed(float luminous_flux, float distance, float rho, float ev100) {
    // ... and the sensor
    return exposed_luminance(card_luminance(luminous_flux, distance, rho), ev100);
}

float card_toned(float luminous_flux, float distance, float rho, float ev100, int curve) {
    // ... and the screen
    return tone_curve(card_exposed(luminous_flux, distance, rho, ev100), curve);
}

float card_stored(float luminous_flux, float distance, float rho, float ev100, int curve) {
    // ... and the file
    return stored_number(card_toned(luminous_flux, distance, rho, ev100, curve));
}
