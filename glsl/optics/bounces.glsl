#include "core/azimuth.glsl"
#include "core/constants.glsl"
#include "core/gauss.glsl"
#include "optics/beckmann.glsl"
#include "optics/materials.glsl"

// Light that meets a second facet: what D and G alone lose. m above 1 is taken as 1, n.v below 0.01 as 0.01

float facets_lost(float n_dot_v, float m) {
    // Of facets in V-grooves that mirror all: the share that meets a second one, int D (G1 - G) u dw_h / n.v. G1 u - G u
    // is u, then 2a - (4c^2 - 1) u, then, for steep facets, 4a - 4c^2 u; never a difference of shares. 12 tilts
    float mu = clamp(n_dot_v, 0.01, 1.0), rough = clamp(m, SMOOTHEST, 1.0), sum = 0.0;
    for (int i = 0; i < 12; i++) {
        float x = 3.0 * GAUSS_X[i], slope = rough * x, c = inversesqrt(1.0 + slope * slope), a = c * mu;
        float wide = max(slope * c * sqrt((1.0 - mu) * (1.0 + mu)), 1e-30), lit = 0.5 * a / (c * c), k = 4.0 * c * c - 1.0;
        float end = k > 1.0 ? 2.0 * a / k : 2.0 * a; // where the second piece is 0, or the third begins
        vec2 low = azimuths_between(a, wide, 0.0, min(lit, 2.0 * a)), next = azimuths_between(a, wide, lit, end);
        float lost = a * low.x + wide * low.y + (2.0 - k) * a * next.x - k * wide * next.y;
        if (k <= 1.0) {
            vec2 seen = azimuths_between(a, wide, 2.0 * a, lit), last = azimuths_between(a, wide, max(lit, 2.0 * a), a / (c * c));
            lost += 2.0 * a * seen.x + (3.0 - k) * a * last.x - (k + 1.0) * wide * last.y;
        }
        sum += GAUSS_W[i] * x * exp(-x * x) / c * lost;
    }
    return 6.0 / PI * sum / mu;
}

float facets_lost_average(float m) {
    // 2 int facets_lost mu dmu, fitted here
    float x = clamp(m, SMOOTHEST, 1.0);
    return x * x * (0.50765469 + x * (-0.09646055 + x * (0.10227136 + x * (-0.35423716 + x * 0.17643248))));
}

float bounced_share(float f_average, float m) {
    // Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks: of what is lost, F^2 E (1 + F (1 - E) + ...)
    float f = clamp(f_average, 0.0, 1.0), lost = facets_lost_average(m);
    return f * f * (1.0 - lost) / (1.0 - f * lost);
}

// 2 int f_material mu dmu of the metals, no channel above 1
const vec3 METAL_F_AVERAGE[5] = vec3[5](vec3(1.0, 0.74179012, 0.4017285), vec3(0.98838957, 0.98318318, 0.9781458), vec3(0.92626244, 0.63267594, 0.53978826), vec3(0.525078, 0.51032499, 0.49653982), vec3(0.89431568, 0.90532885, 0.91453715));

vec3 f_material_average(int material) {
    // Walsh 1926 for insulators; metals by 24 angles
    if (material < INSULATORS) return vec3(f_average_dielectric(material_eta(material)));
    return METAL_F_AVERAGE[clamp(material - INSULATORS, 0, 4)];
}

vec3 bounced_light(float n_dot_l, float n_dot_v, float m, int material, float irradiance_facing, float radiance) {
    // Kulla and Conty 2017: what leaves after a second facet, of a lamp and of an even room
    vec3 f = f_material_average(material), share = vec3(bounced_share(f.r, m), bounced_share(f.g, m), bounced_share(f.b, m));
    float lamp = n_dot_l > 0.0 ? irradiance_facing * n_dot_l * facets_lost(n_dot_l, m) / (PI * facets_lost_average(m)) : 0.0;
    return share * (facets_lost(n_dot_v, m) * (lamp + radiance));
}

vec3 bounced_light_none(float n_dot_l, float n_dot_v, float m, int material, float irradiance_facing, float radiance) {
    // Cook and Torrance 1982: light that meets a second facet is lost
    return vec3(0.0);
}

float bounced_light_error(int material, float m) {
    // The largest share of the light that a second facet sends back, over 32 angles and three channels
    vec3 f = f_material_average(material);
    float lost = 0.0;
    for (int i = 1; i <= 32; i++) lost = max(lost, facets_lost(float(i) / 32.0, m));
    return lost * bounced_share(max(f.r, max(f.g, f.b)), m);
}
