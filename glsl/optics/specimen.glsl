#include "optics/lambert.glsl"
#include "optics/phong.glsl"
#include "optics/spherical.glsl"

// Surfaces made up to show what a BRDF is, and what it must not be.

float brdf_paint(vec3 n, vec3 l, vec3 v, int channel, float k_s, float exponent) {
    // The BRDF (2): a function of two directions and of the wavelength; red paint under a clear varnish
    float rho = channel == 0 ? 0.62 : channel == 1 ? 0.16 : 0.10;
    return (1.0 - k_s) * brdf_lambert(n, l, v, rho) + brdf_phong(n, l, v, 0.0, k_s, exponent);
}

float brdf_flawed(vec3 n, vec3 l, vec3 v, float radiance, int flaw, float k_d, float k_s, float exponent) {
    // The BRDF (3): its properties, each broken once; times the incoming radiance, to which one of them answers
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    if (n_dot_l <= 0.0 || n_dot_v <= 0.0) return 0.0;
    float gloss = brdf_phong(n, l, v, 0.0, k_s, exponent), body = k_d / PI, away = 1.0 - n_dot_l;
    if (flaw == 1) body -= k_d;                                                   // a fit that swings below zero
    if (flaw == 2) body *= 1.0 - away * away;                                     // the way in, and not the way out
    if (flaw == 3) body = k_d;                                                    // the forgotten 1 / pi
    if (flaw == 5) {                                                              // 0 / 0 where l or v stands on n
        vec3 a = l - n_dot_l * n, b = v - n_dot_v * n;
        body *= 1.0 + 0.5 * dot(a, b) / sqrt(dot(a, a) * dot(b, b));
    }
    float f = body + gloss;
    return flaw == 4 ? min(radiance * f, 1.0) : radiance * f;                     // 4: cut off at 1
}

float ratio_flawed(vec3 n, vec3 l, vec3 v, float radiance, int flaw, float k_d, float k_s, float exponent) {
    // The BRDF (1): what comes out per what comes in; of a BRDF it is the same for every radiance
    return brdf_flawed(n, l, v, radiance, flaw, k_d, k_s, exponent) / radiance;
}

float hemisphere_meter(float theta_v, float radiance, int flaw, float k_d, float k_s, float exponent, int weight) {
    // The BRDF (3): int f dw, or with weight 1 int f cos theta dw; 48 Gauss-Legendre nodes in the cosine, 96 around
    vec3 n = vec3(0.0, 0.0, 1.0), v = view_direction(theta_v);
    float sum = 0.0;
    for (int i = 0; i < 48; i++) {
        int k = i % 24;
        float z = i < 24 ? 0.5 * LEGENDRE_X[k] : 0.5 + 0.5 * LEGENDRE_X[k], r = sqrt((1.0 - z) * (1.0 + z)), row = 0.0;
        for (int j = 0; j < 96; j += 12) { // a dozen at a time: long sums of equal terms drift in float32
            float dozen = 0.0;
            for (int at = j; at < j + 12; at++) {
                float turn = (float(at) + 0.5) * PI / 48.0;
                dozen += brdf_flawed(n, vec3(r * cos(turn), r * sin(turn), z), v, radiance, flaw, k_d, k_s, exponent);
            }
            row += dozen;
        }
        sum += 0.5 * LEGENDRE_W[k] * (weight == 1 ? z : 1.0) * row;
    }
    return sum * PI / 48.0 / radiance;
}

float paint_measured(float theta_l, float phi, float theta_v, float half_angle, int channel, float k_s, float exponent) {
    // The BRDF (1): dL_o / (L_i cos theta_i dw_i) with a lamp of some size: 24 Gauss-Legendre rings of 32 directions
    vec3 n = vec3(0.0, 0.0, 1.0), l = light_direction(theta_l, phi), v = view_direction(theta_v);
    vec3 a = direction_theta(theta_l, phi), b = direction_phi(phi);
    float s = sin(0.5 * half_angle);
    vec2 sum = vec2(0.0); // irradiance, radiance
    for (int i = 0; i < 24; i++) {
        float q = 2.0 * s * s * LEGENDRE_X[i], r = sqrt(q * (2.0 - q)); // q = 1 - cos
        vec2 ring = vec2(0.0);
        for (int j = 0; j < 32; j += 8) { // eight at a time: long sums of equal terms drift in float32
            vec2 part = vec2(0.0);
            for (int at = j; at < j + 8; at++) {
                float turn = (float(at) + 0.5) * PI / 16.0;
                vec3 d = l - q * l + r * (cos(turn) * a + sin(turn) * b);
                part += max(d.z, 0.0) * vec2(1.0, brdf_paint(n, d, v, channel, k_s, exponent));
            }
            ring += part;
        }
        sum += LEGENDRE_W[i] * ring;
    }
    return sum.y / sum.x;
}
