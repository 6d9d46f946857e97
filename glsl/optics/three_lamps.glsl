#include "core/angle.glsl"
#include "core/constants.glsl"
#include "optics/photometry.glsl"
#include "optics/radiometry.glsl"

const vec3 LAMPS[3] = vec3[3](vec3(1.2, 0.0, 1.15), vec3(0.45, -0.75, 1.5), vec3(2.0, 0.7, 1.0));

float lamp_flux(int globe, float luminous_flux) {
    // Ours: one to change, two that stay
    return globe == 0 ? luminous_flux : globe == 1 ? 600.0 : 250.0;
}

float lamp_intensity(int globe, float luminous_flux) {
    // Plausible Shading - Measuring Light: Phi / (4 pi)
    return luminous_intensity_isotropic(lamp_flux(globe, luminous_flux));
}

float lamp_luminance(int globe, float luminous_flux, float source_radius) {
    // D5 of the optics reference: I over the area of the disk one sees
    return lamp_intensity(globe, luminous_flux) / (PI * source_radius * source_radius);
}

float lamp_inverse_square(int globe, float luminous_flux, float from_wall, float along_wall) {
    // Plausible Shading - Measuring Light: I / r^2
    vec3 way = LAMPS[globe] - vec3(from_wall, along_wall, 0.0);
    return lamp_intensity(globe, luminous_flux) / dot(way, way);
}

float lamp_illuminance(int globe, float luminous_flux, float from_wall, float along_wall) {
    // Plausible Shading - Measuring Light, with the floor's cosine
    float r = length(LAMPS[globe] - vec3(from_wall, along_wall, 0.0));
    return lamp_inverse_square(globe, luminous_flux, from_wall, along_wall) * LAMPS[globe].z / r;
}

float lamps_illuminance(float luminous_flux, float from_wall, float along_wall) {
    // Light adds up
    float sum = 0.0;
    for (int k = 0; k < 3; k++) sum += lamp_illuminance(k, luminous_flux, from_wall, along_wall);
    return sum;
}

float lamps_illuminance_by_area(float luminous_flux, float source_radius, float from_wall, float along_wall) {
    // Luminance times projected solid angle
    float sum = 0.0;
    for (int k = 0; k < 3; k++) {
        vec3 way = LAMPS[k] - vec3(from_wall, along_wall, 0.0);
        float slant = arctan2(length(way.xy), way.z);
        sum += irradiance_sphere(lamp_luminance(k, luminous_flux, source_radius), source_radius, length(way), slant);
    }
    return sum;
}

float luminance_over_inverse_square(float source_radius, float distance) {
    // D5 of the optics reference
    return distance * distance / (PI * source_radius * source_radius);
}
