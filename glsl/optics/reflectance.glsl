#include "optics/punctual.glsl"
#include "optics/solid_angle.glsl"

// The balance of energy at dA: what arrives is reflected, scattered, or absorbed.

float exitance_reflected(float k_s, float irradiance_facing, float theta_l) {
    // The Reflectance Equation (1): energy reflected
    return k_s * irradiance_directional(irradiance_facing, theta_l);
}

float exitance_scattered(float k_d, float irradiance_facing, float theta_l) {
    // The Reflectance Equation (1): energy scattered, as a local effect
    return k_d * irradiance_directional(irradiance_facing, theta_l);
}

float exitance_leaving(float k_d, float k_s, float irradiance_facing, float theta_l) {
    // The Reflectance Equation (1): what leaves is reflected and scattered; what is absorbed does not leave
    return (k_d + k_s) * irradiance_directional(irradiance_facing, theta_l);
}

float irradiance_absorbed(float k_d, float k_s, float irradiance_facing, float theta_l) {
    // The Reflectance Equation (1): the rest; below 0 the surface would make light
    return ((1.0 - k_d) - k_s) * irradiance_directional(irradiance_facing, theta_l);
}

// The hemisphere in tiles: rows from the pole down, four times as many columns.

float cosine_sum(int tile_rows, float half_angle) {
    // Lambertian Surfaces (1): int cos theta dw over a cap, as a sum over tiles, each with the cosine of its middle
    float high = half_angle / float(tile_rows), sum = 0.0;
    for (int i = 0; i < tile_rows; i++) {
        float theta = (float(i) + 0.5) * high;
        sum += max(cos(theta), 0.0) * solid_angle_cell(theta, high, 2.0 * PI);
    }
    return sum;
}
