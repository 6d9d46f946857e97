#include "optics/area_light.glsl"

// Shapes: 0 panel, 1 disk, 2 sphere, 3 polygon; panel_width is the diameter of a disk or sphere, and a disk looks down

float light_area(int light_shape, float panel_width, float panel_depth) {
    // Area Lights: what radiates: one side of a flat light, all of a sphere; the pentagon is 0.68 of its panel
    if (light_shape == 1) return 0.25 * PI * panel_width * panel_width;
    if (light_shape == 2) return PI * panel_width * panel_width;
    return (light_shape == 3 ? 0.68 : 1.0) * panel_width * panel_depth;
}

float light_exitance(int given, float amount, int light_shape, float panel_width, float panel_depth) {
    // Area Lights: M = Phi / A = pi L
    return given == 0 ? amount / light_area(light_shape, panel_width, panel_depth) : given == 1 ? amount : PI * amount;
}

float light_radiance(int given, float amount, int light_shape, float panel_width, float panel_depth) {
    // Area Lights: L = M / pi, for a light that looks alike from everywhere
    return given == 2 ? amount : light_exitance(given, amount, light_shape, panel_width, panel_depth) / PI;
}

float light_flux(int given, float amount, int light_shape, float panel_width, float panel_depth) {
    // Area Lights: Phi = M A
    return given == 0 ? amount : light_exitance(given, amount, light_shape, panel_width, panel_depth) * light_area(light_shape, panel_width, panel_depth);
}

float irradiance_light(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Light Contribution of Area Lights (1): L times the projected solid angle
    vec3 way = vec3(light_x, light_y, light_height) - position;
    float aside = length(way.xy);
    if (light_shape == 1) return way.z > 0.0 ? irradiance_disk_light(radiance, 0.5 * panel_width, way.z, aside) : 0.0;
    if (light_shape == 2) return irradiance_sphere_light(radiance, 0.5 * panel_width, length(way), arctan2(aside, way.z));
    return irradiance_outline(light_shape == 0 ? 4 : 5, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position);
}

float light_irradiance_below(int given, float amount, int light_shape, float light_height, float panel_width, float panel_depth, float panel_tilt) {
    // Area Lights: the irradiance of the floor straight below the middle of a light of which one number is given
    float radiance = light_radiance(given, amount, light_shape, panel_width, panel_depth);
    return irradiance_light(light_shape, radiance, 0.0, 0.0, light_height, panel_width, panel_depth, panel_tilt, vec3(0.0));
}
