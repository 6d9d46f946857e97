#include "core/constants.glsl"
#include "core/disk.glsl"
#include "optics/solid_angle.glsl"
#include "optics/projected_solid_angle.glsl"
#include "optics/square_patch.glsl"

float radiant_flux_mean(float radiant_energy, float duration) {
    // Basic Radiometric Quantities (1): Phi = Q / t
    return radiant_energy / duration;
}

float radiant_energy_emitted(float radiant_energy, float duration, float time) {
    // Basic Radiometric Quantities (1): the integral of the flux up to now
    return radiant_energy * min(1.0, max(0.0, time) / duration);
}

float radiant_intensity_isotropic(float radiant_flux) {
    // Measuring Light: I = Phi / 4 pi, for a source that is even in all directions
    return radiant_flux / (4.0 * PI);
}

float radiant_intensity_cone(float radiant_flux, float half_angle) {
    // Basic Radiometric Quantities (1): flux over solid angle
    return radiant_flux / solid_angle_cone(half_angle);
}

float radiant_intensity_lambert(float radiant_flux, float theta) {
    // Lambert 1760: the cosine law of a flat source
    return radiant_flux / PI * max(0.0, cos(theta));
}

float radiant_flux_lambert_cone(float radiant_flux, float half_angle) {
    // Lambert 1760: the integral of the cosine law over a cone
    return radiant_flux / PI * projected_solid_angle_cone(half_angle);
}

float radiant_intensity_lambert_cone(float radiant_flux, float half_angle) {
    // Basic Radiometric Quantities (1): the mean over a cone
    float c = cos(0.5 * half_angle);
    return half_angle <= 0.5 * PI ? radiant_flux / PI * c * c : radiant_intensity_cone(radiant_flux, half_angle);
}

float irradiance_point(float radiant_intensity, float distance, float theta) {
    // Measuring Light: I cos / r^2, divided twice; infinite at r = 0
    return radiant_intensity * max(0.0, cos(theta)) / distance / distance;
}

float irradiance_isotropic(float radiant_flux, float distance) {
    // Measuring Light: Phi / (4 pi r^2)
    return irradiance_point(radiant_intensity_isotropic(radiant_flux), distance, 0.0);
}

float irradiance_cap(float radiance, float half_angle) {
    // Basic Radiometric Quantities (3): pi L sin^2
    return radiance * projected_solid_angle_cone(half_angle);
}

float irradiance_without_cosine(float radiance, float half_angle) {
    // A common mistake: radiance times solid angle
    return radiance * solid_angle_cone(half_angle);
}

float irradiance_sphere(float radiance, float radius, float distance, float theta) {
    // Snyder 1969: radiance times projected solid angle
    return radiance * projected_solid_angle_sphere(radius, distance, theta);
}

float irradiance_disk(float radiance, float radius, float height, float offset) {
    // Howell, B-12: radiance times projected solid angle
    vec2 seen = parallel_disk(radius, height, offset);
    return radiance * seen.x * seen.y;
}

float irradiance_disk_naive(float radiance, float radius, float height, float offset) {
    // Howell, B-12, as printed: 1 less almost 1
    return radiance * projected_solid_angle_disk_naive(radius, height, offset);
}

float irradiance_round_far(float radiance, float radius, float distance) {
    // Measuring Light: a round source as if it were a point
    float seen = radius / distance;
    return PI * radiance * seen * seen;
}

float inverse_square_excess(float radius, float distance) {
    // Measuring Light: how much too large that is for a disk
    float seen = radius / distance;
    return seen * seen;
}

float irradiance_piece(int sky_piece, float radiance, float opening, float theta) {
    // Basic Radiometric Quantities (3): a cap overhead, a round sun, a square window
    float size = sin(opening);
    if (sky_piece == 0) return radiance * (PI * size * size);
    if (sky_piece == 1) return irradiance_sphere(radiance, size, 1.0, theta);
    return radiance * projected_solid_angle_patch(theta, 1.0, 0.0, 2.0 * size);
}

float irradiance_sensor(float radiance, float half_angle, float theta) {
    // Basic Radiometric Quantities (3): an even radiance through a round opening
    return irradiance_sphere(radiance, sin(half_angle), 1.0, theta);
}

float radiant_flux_sensor(float radiance, float patch_area, float half_angle, float theta) {
    // Basic Radiometric Quantities (2): on a small sensor
    return patch_area * irradiance_sensor(radiance, half_angle, theta);
}

float radiant_energy_sensor(float radiance, float patch_area, float half_angle, float theta, float duration) {
    // Basic Radiometric Quantities (1): flux times time
    return radiant_flux_sensor(radiance * duration, patch_area, half_angle, theta);
}

float radiance_sensor_projected(float radiance, float patch_area, float half_angle, float theta) {
    // Nicodemus 1963: flux over area and projected solid angle, exact for any opening
    float seen = irradiance_sensor(1.0, half_angle, theta);
    return seen > 0.0 ? radiant_flux_sensor(radiance, patch_area, half_angle, theta) / patch_area / seen : 0.0;
}

float radiance_sensor(float radiance, float patch_area, float half_angle, float theta) {
    // Basic Radiometric Quantities (2): flux over area, solid angle and cosine
    float flux = radiant_flux_sensor(radiance, patch_area, half_angle, theta);
    return flux / patch_area / solid_angle_cone(half_angle) / abs(cos(theta));
}

float radiant_intensity_spot(float radiance, float half_angle, float distance) {
    // Basic Radiometric Quantities (2): radiance times the area of wall that is seen
    float reach = distance * tan(half_angle);
    return radiance * PI * reach * reach;
}

float radiance_twice_as_far(float half_angle, float distance) {
    // Basic Radiometric Quantities (2): the spot grows as each part of it gives less
    float reach = distance * tan(half_angle);
    return projected_solid_angle_disk(2.0 * reach, 2.0 * distance, 0.0) / projected_solid_angle_disk(reach, distance, 0.0);
}

float radiant_exitance_reflected(float rho, float irradiance) {
    // Basic Radiometric Quantities (3): B = rho E
    return rho * irradiance;
}

float radiant_exitance_absorbed(float rho, float irradiance) {
    // The balance of energy: what is not sent back is kept
    return (1.0 - rho) * irradiance;
}

float radiance_lambert(float rho, float irradiance) {
    // Lambert 1760: B / pi, in all directions the same
    return rho * irradiance / PI;
}

float intensity_per_area_lambert(float rho, float irradiance, float theta) {
    // Lambert 1760: the cosine law
    return radiance_lambert(rho, irradiance) * max(0.0, cos(theta));
}

float radiance_lambert_over_hemisphere(float rho, float irradiance) {
    // A common mistake: the cosine forgotten, B / 2 pi
    return rho * irradiance / (2.0 * PI);
}

float radiant_exitance_lambert(float radiance) {
    // Lambert 1760: pi L
    return PI * radiance;
}
