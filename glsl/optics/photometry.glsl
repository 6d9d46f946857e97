#include "core/constants.glsl"
#include "core/exponential.glsl"
#include "optics/radiometry.glsl"

// CIE 1924 photopic V(lambda), 380 to 780 nm every 5 nm: CIE 018:2019
const float V_LAMBDA[81] = float[81](
    0.000039, 0.000064, 0.00012, 0.000217, 0.000396, 0.00064, 0.00121, 0.00218, 0.004, 0.0073,
    0.0116, 0.01684, 0.023, 0.0298, 0.038, 0.048, 0.06, 0.0739, 0.09098, 0.1126,
    0.13902, 0.1693, 0.20802, 0.2586, 0.323, 0.4073, 0.503, 0.6082, 0.71, 0.7932,
    0.862, 0.91485, 0.954, 0.9803, 0.99495, 1.0, 0.995, 0.9786, 0.952, 0.9154,
    0.87, 0.8163, 0.757, 0.6949, 0.631, 0.5668, 0.503, 0.4412, 0.381, 0.321,
    0.265, 0.217, 0.175, 0.1382, 0.107, 0.0816, 0.061, 0.04458, 0.032, 0.0232,
    0.017, 0.01192, 0.00821, 0.005723, 0.004102, 0.002929, 0.002091, 0.001484, 0.001047, 0.00074,
    0.00052, 0.000361, 0.000249, 0.000172, 0.00012, 0.0000848, 0.00006, 0.0000424, 0.00003, 0.0000212,
    0.00001499
);
const float K_CD = 683.0; // lm/W at 540 THz, exact: SI brochure 2019
const float K_M = 683.002; // lm/W at 555 nm in air: CIE 018:2019
const float C_1 = 1.1910429724e20; // 2 h c^2 in W nm^4 / (m^2 sr): CODATA 2018
const float C_2 = 14387768.775; // h c / k in nm K: CODATA 2018
const float STEFAN = 5.670374419e-8; // W / (m^2 K^4): CODATA 2018
const float WIEN = 2897771.955; // nm K: CODATA 2018

float luminous_efficiency(float wavelength) {
    // CIE 018:2019, the table, linear in between
    if (wavelength < 380.0 || wavelength > 780.0) return 0.0;
    float at = (wavelength - 380.0) / 5.0;
    int i = min(int(at), 79);
    return mix(V_LAMBDA[i], V_LAMBDA[i + 1], at - float(i));
}

float luminous_efficacy_monochromatic(float wavelength) {
    // Units for Lighting - Lumen: 683 lm/W at 555 nm
    return K_M * luminous_efficiency(wavelength);
}

float luminous_flux_radiated(float radiant_flux, float radiation_efficacy) {
    // Units for Lighting - Lumen: per watt of light
    return radiant_flux * radiation_efficacy;
}

float luminous_flux_source(float electrical_power, float source_efficacy) {
    // Units for Lighting - Lumen: per watt from the mains
    return electrical_power * source_efficacy;
}

float luminous_intensity_isotropic(float luminous_flux) {
    // Units for Lighting - Candela: flux per solid angle
    return luminous_flux / (4.0 * PI);
}

float radiant_intensity_540thz(float luminous_intensity) {
    // SI brochure 2019: the definition of the candela
    return luminous_intensity / K_CD;
}

float illuminance_point(float luminous_intensity, float distance, float theta) {
    // Units for Lighting - Candela: I cos / r^2
    return irradiance_point(luminous_intensity, distance, theta);
}

float illuminance_isotropic(float luminous_flux, float distance, float theta) {
    // Units for Lighting - Candela: Phi cos / (4 pi r^2)
    return illuminance_point(luminous_intensity_isotropic(luminous_flux), distance, theta);
}

float luminance_lambert(float rho, float illuminance) {
    // Lambert 1760: rho E / pi
    return rho * illuminance / PI;
}

float planck_relative(float wavelength, float wavelength_high, float temperature) {
    // Planck 1901: the quotient of two wavelengths, their exponents subtracted while they are exact
    float x = C_2 / (wavelength * temperature), x_high = C_2 / (wavelength_high * temperature);
    float step = x_high * ((wavelength - wavelength_high) / wavelength), size = wavelength_high / wavelength;
    return size * size * size * size * size * exp(step) * one_less_exp(x_high) / one_less_exp(x);
}

float planck_radiance(float wavelength, float temperature) {
    // Planck 1901, with e^-x: nothing overflows, nothing cancels
    float x = C_2 / (wavelength * temperature), square = wavelength * wavelength;
    return C_1 / (square * square * wavelength) * exp(-x) / one_less_exp(x);
}

float planck_radiance_naive(float wavelength, float temperature) {
    // Planck 1901, as printed
    float x = C_2 / (wavelength * temperature), square = wavelength * wavelength;
    return C_1 / (square * square * wavelength) / (exp(x) - 1.0);
}

float led_spectrum(float wavelength) {
    // Ours, fitted by eye: a blue line and the glow of a phosphor
    float blue = (wavelength - 452.0) / 10.0, glow = (wavelength - 585.0) / 58.0;
    return 0.9 * exp(-0.5 * blue * blue) + exp(-0.5 * glow * glow);
}

float lamp_spectrum(int lamp, float wavelength, float temperature) {
    // Units for Lighting - Lumen: black body, LED, equal energy
    if (lamp == 0) return planck_relative(wavelength, clamp(WIEN / temperature, 380.0, 780.0), temperature);
    return lamp == 1 ? led_spectrum(wavelength) : 1.0;
}

float luminous_efficacy_planck(float temperature) {
    // Units for Lighting - Watts: what is seen, over all that is radiated
    float seen = 0.0;
    for (int i = 0; i < 81; i += 9) { // sums of sums keep their digits
        float here = 0.0;
        for (int j = i; j < i + 9; j++) here += V_LAMBDA[j] * planck_radiance(380.0 + 5.0 * float(j), temperature);
        seen += here;
    }
    float square = temperature * temperature;
    return K_M * 5.0 * seen / (STEFAN / PI * square * square);
}

float luminous_efficacy_band(float temperature, float wavelength_low, float wavelength_high) {
    // Murphy 2012, Maximum spectral luminous efficacy of white light: a black body's light between two wavelengths
    float seen = 0.0, whole = 0.0, wide = wavelength_high - wavelength_low;
    for (int i = 0; i < 20; i++) { // sums of sums keep their digits
        float seen_here = 0.0, whole_here = 0.0;
        for (int j = 0; j < 20; j++) {
            float at = wavelength_low + wide * (float(20 * i + j) + 0.5) / 400.0, light = planck_radiance(at, temperature);
            seen_here += luminous_efficiency(at) * light;
            whole_here += light;
        }
        seen += seen_here;
        whole += whole_here;
    }
    return K_M * seen / whole;
}

float luminous_efficacy_lamp(int lamp, float temperature) {
    // Units for Lighting - Lumen: per radiated watt
    if (lamp == 0) return luminous_efficacy_planck(temperature);
    float seen = 0.0, whole = 0.0;
    for (int i = 0; i < 81; i++) {
        float light = (i == 0 || i == 80 ? 0.5 : 1.0) * (lamp == 1 ? led_spectrum(380.0 + 5.0 * float(i)) : 1.0);
        seen += V_LAMBDA[i] * light;
        whole += light;
    }
    return K_M * seen / whole;
}
