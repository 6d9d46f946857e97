#include "optics/phong.glsl"
#include "optics/solid_angle.glsl"
#include "optics/spherical.glsl"

// The reflectance equation under a sky that is made up: blue, a hazy sun, a dark tree. n is +z.

float sky_radiance(vec3 l, vec3 to_sun, float zenith_radiance, float sun_radiance) {
    // The Reflectance Equation (3), its L_i: polynomials of the direction, so that a quadrature is exact
    float low = 1.0 - l.z, glow = 0.5 + 0.5 * dot(l, to_sun), tree = 0.5 + 0.5 * dot(l, vec3(-0.48, 0.86, 0.173205081));
    for (int i = 0; i < 7; i++) glow *= glow; // to the power 128
    for (int i = 0; i < 6; i++) tree *= tree; // to the power 64
    return l.z > 0.0 ? (zenith_radiance * (1.0 + 1.5 * low * low) + sun_radiance * glow) * (1.0 - 0.94 * tree) : 0.0;
}

float reflected_part(vec3 l, vec3 to_sun, vec3 v, float zenith_radiance, float sun_radiance, float k_d, float k_s, float exponent) {
    // The Reflectance Equation (3): what stands under the integral, f L_i cos theta_i
    vec3 n = vec3(0.0, 0.0, 1.0);
    return brdf_phong(n, l, v, k_d, k_s, exponent) * sky_radiance(l, to_sun, zenith_radiance, sun_radiance) * max(l.z, 0.0);
}

float reflected_radiance_sum(int tile_rows, float theta_l, float phi, float theta_v, float zenith_radiance, float sun_radiance, float k_d, float k_s, float exponent) {
    // The Reflectance Equation (3) as a sum over tiles of the sky, each taken at its middle
    vec3 to_sun = light_direction(theta_l, phi), v = view_direction(theta_v);
    float high = 0.5 * PI / float(tile_rows), sum = 0.0;
    for (int i = 0; i < tile_rows; i++) {
        float theta = (float(i) + 0.5) * high, row = 0.0;
        for (int j = 0; j < 4 * tile_rows; j++) {
            vec3 l = direction(theta, (float(j) + 0.5) * high);
            row += reflected_part(l, to_sun, v, zenith_radiance, sun_radiance, k_d, k_s, exponent);
        }
        sum += solid_angle_cell(theta, high, high) * row;
    }
    return sum;
}

float reflected_radiance(float theta_l, float phi, float theta_v, float zenith_radiance, float sun_radiance, float k_d, float k_s, float exponent) {
    // The Reflectance Equation (3): 48 Gauss-Legendre nodes in cos theta, 96 even ones in azimuth
    vec3 to_sun = light_direction(theta_l, phi), v = view_direction(theta_v);
    float sum = 0.0;
    for (int i = 0; i < 48; i++) {
        int k = i % 24;
        float z = i < 24 ? 0.5 * LEGENDRE_X[k] : 0.5 + 0.5 * LEGENDRE_X[k], r = sqrt((1.0 - z) * (1.0 + z)), row = 0.0;
        for (int j = 0; j < 96; j++) {
            float turn = (float(j) + 0.5) * PI / 48.0;
            row += reflected_part(vec3(r * cos(turn), r * sin(turn), z), to_sun, v, zenith_radiance, sun_radiance, k_d, k_s, exponent);
        }
        sum += 0.5 * LEGENDRE_W[k] * row;
    }
    return sum * PI / 48.0;
}

float sun_share(float theta_l, float phi, float theta_v, float zenith_radiance, float sun_radiance, float k_d, float k_s, float exponent) {
    // The Reflectance Equation (3) is linear in L_i: what the sun gives alone it gives among the rest
    float whole = reflected_radiance(theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent);
    return whole > 0.0 ? reflected_radiance(theta_l, phi, theta_v, 0.0, sun_radiance, k_d, k_s, exponent) / whole : 0.0;
}
