#include "optics/colour.glsl"
#include "optics/fresnel.glsl"

// The deck's two tables, Fresnel Term (7) and (6), as printed: water, plastic or glass (low), plastic (high),
// glass (high) or ruby, diamond; gold, silver, copper, iron, aluminium
const int INSULATORS = 5;
const vec3 PRINTED_F0[10] = vec3[10](
    vec3(0.02, 0.02, 0.02),
    vec3(0.03, 0.03, 0.03),
    vec3(0.05, 0.05, 0.05),
    vec3(0.08, 0.08, 0.08),
    vec3(0.17, 0.17, 0.17),
    vec3(1.00, 0.71, 0.29),
    vec3(0.95, 0.93, 0.88),
    vec3(0.95, 0.64, 0.54),
    vec3(0.56, 0.57, 0.58),
    vec3(0.91, 0.92, 0.92));
const vec3 PRINTED_SRGB[10] = vec3[10](
    vec3(0.15, 0.15, 0.15),
    vec3(0.21, 0.21, 0.21),
    vec3(0.24, 0.24, 0.24),
    vec3(0.31, 0.31, 0.31),
    vec3(0.45, 0.45, 0.45),
    vec3(1.00, 0.86, 0.57),
    vec3(0.98, 0.97, 0.95),
    vec3(0.98, 0.82, 0.76),
    vec3(0.77, 0.78, 0.78),
    vec3(0.96, 0.96, 0.97));
// Measured at 589 nm: water, fused silica, polystyrene, ruby, diamond
const float INDEX_ETA[5] = float[5](1.333, 1.4585, 1.592, 1.768, 2.4175);
// Johnson & Christy 1972, 1974, Rakic 1995: eta, k at twelve wavelengths, for each metal
const vec2 INDEX_GOLD[12] = vec2[12](
    vec2(1.47, 1.952), vec2(1.46, 1.958), vec2(1.45, 1.948), vec2(1.38, 1.914), vec2(1.31, 1.849), vec2(1.04, 1.833),
    vec2(0.62, 2.081), vec2(0.43, 2.455), vec2(0.29, 2.863), vec2(0.21, 3.272), vec2(0.14, 3.697), vec2(0.13, 4.103));
const vec2 INDEX_SILVER[12] = vec2[12](
    vec2(0.05, 2.07), vec2(0.05, 2.275), vec2(0.04, 2.462), vec2(0.04, 2.657), vec2(0.05, 2.869), vec2(0.05, 3.093),
    vec2(0.05, 3.324), vec2(0.06, 3.586), vec2(0.05, 3.858), vec2(0.06, 4.152), vec2(0.05, 4.483), vec2(0.04, 4.838));
const vec2 INDEX_COPPER[12] = vec2[12](
    vec2(1.32, 2.116), vec2(1.28, 2.207), vec2(1.25, 2.305), vec2(1.24, 2.397), vec2(1.25, 2.483), vec2(1.22, 2.564),
    vec2(1.18, 2.608), vec2(1.02, 2.577), vec2(0.7, 2.704), vec2(0.3, 3.205), vec2(0.22, 3.747), vec2(0.21, 4.205));
const vec2 INDEX_IRON[12] = vec2[12](
    vec2(2.24, 2.58), vec2(2.35, 2.65), vec2(2.48, 2.71), vec2(2.59, 2.77), vec2(2.67, 2.82), vec2(2.74, 2.88),
    vec2(2.86, 2.91), vec2(2.95, 2.93), vec2(2.94, 2.99), vec2(2.88, 3.05), vec2(2.92, 3.1), vec2(2.86, 3.19));
const vec2 INDEX_ALUMINIUM[12] = vec2[12](
    vec2(0.4813, 4.8032), vec2(0.5214, 5.001), vec2(0.5718, 5.2148), vec2(0.6364, 5.4652), vec2(0.7085, 5.7122), vec2(0.7975, 6.0002),
    vec2(0.8917, 6.2914), vec2(1.0092, 6.6111), vec2(1.1692, 6.9882), vec2(1.3497, 7.3707), vec2(1.6235, 7.7998), vec2(1.9581, 8.1749));
// What each wavelength adds to linear sRGB in daylight
const vec3 WEIGHT_RGB[12] = vec3[12](
    vec3(0.00166, -0.00144, 0.01017),
    vec3(0.00891, -0.00792, 0.05689),
    vec3(0.03306, -0.03154, 0.24956),
    vec3(0.02592, -0.03533, 0.40547),
    vec3(-0.04730, 0.02233, 0.29555),
    vec3(-0.14016, 0.13672, 0.08943),
    vec3(-0.21814, 0.33231, -0.01127),
    vec3(-0.00878, 0.40730, -0.04681),
    vec3(0.49273, 0.20513, -0.03522),
    vec3(0.63322, -0.00762, -0.01183),
    vec3(0.20338, -0.01826, -0.00184),
    vec3(0.01550, -0.00168, -0.00010));

vec3 material_f0(int material) {
    // Fresnel Term (6), (7): linear, as printed
    return PRINTED_F0[material];
}

vec3 material_srgb(int material) {
    // Fresnel Term (6), (7): sRGB, as printed
    return PRINTED_SRGB[material];
}

float material_eta(int material) {
    // Malitson 1965 and others: a measured index for a row of the table; 1 for metals
    return material < INSULATORS ? INDEX_ETA[min(material, INSULATORS - 1)] : 1.0;
}

vec2 metal_index(int material, int wavelength_index) {
    // Johnson and Christy 1972, 1974; Rakic 1995: eta and k
    int i = wavelength_index;
    return material <= 5 ? INDEX_GOLD[i] : material == 6 ? INDEX_SILVER[i] : material == 7 ? INDEX_COPPER[i]
        : material == 8 ? INDEX_IRON[i] : INDEX_ALUMINIUM[i];
}

vec3 wavelength_weight(int wavelength_index) {
    // CIE 015:2004, D65 and the 1931 observer
    return WEIGHT_RGB[wavelength_index];
}

vec3 f_material(float l_dot_h, int material) {
    // Fresnel Term (6), (7), from measured indices; metals over twelve wavelengths
    if (material < INSULATORS) return vec3(f_dielectric(l_dot_h, material_eta(material)));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 12; i++) {
        vec2 index = metal_index(material, i);
        sum += wavelength_weight(i) * f_conductor(l_dot_h, index.x, index.y);
    }
    return sum;
}

float material_share(float theta, int material, int channel) {
    // Fresnel Term (4), (5): one channel, by the angle
    return f_material(max(0.0, cos(theta)), material)[channel];
}

float material_share_schlick(float theta, int material, int channel) {
    // Schlick 1994, from the exact share at normal incidence
    return f_schlick(max(0.0, cos(theta)), f_material(1.0, material)[channel]);
}

float material_share_f82(float theta, int material, int channel) {
    // Hoffman 2019, from the exact shares at l_dot_h = 1 and 1/7
    return f_f82(max(0.0, cos(theta)), f_material(1.0, material)[channel], f_material(1.0 / 7.0, material)[channel]);
}

float material_f0_printed(int material, int channel) {
    // Fresnel Term (6), (7)
    return PRINTED_F0[material][channel];
}

float material_srgb_printed(int material, int channel) {
    // Fresnel Term (6), (7)
    return PRINTED_SRGB[material][channel];
}

float material_srgb_of_printed(int material, int channel) {
    // IEC 61966-2-1
    return linear_to_srgb(PRINTED_F0[material][channel]);
}

float schlick_worst(int material) {
    // Schlick 1994, its largest error over 91 angles and three channels
    vec3 f0 = f_material(1.0, material);
    float most = 0.0;
    for (int i = 0; i <= 90; i++) {
        float c = max(0.0, cos(radians(float(i)))), x = 1.0 - c;
        vec3 off = abs(f0 + (1.0 - f0) * (x * x * x * x * x) - f_material(c, material));
        most = max(most, max(off.r, max(off.g, off.b)));
    }
    return most;
}
