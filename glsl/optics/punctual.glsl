vec3 direction_to_light(vec3 position, vec3 light_position) {
    // Punctual Lights - Positional: l = (p_L - x) / |p_L - x|; no direction where they meet
    vec3 way = light_position - position;
    float r = length(way);
    return r > 0.0 ? way / r : vec3(0.0);
}

float irradiance_positional(float radiant_intensity, float distance, float theta, float source_radius) {
    // Plausible Shading - Measuring Light: I cos / r^2, r not below the source's radius
    float r = max(distance, source_radius);
    return radiant_intensity / r * max(cos(theta), 0.0) / r;
}

float irradiance_positional_naive(float radiant_intensity, float distance, float theta, float source_radius) {
    // Plausible Shading - Measuring Light: I cos / r^2, and the cosine is not stopped at 0
    float r = max(distance, source_radius);
    return radiant_intensity / r * cos(theta) / r;
}

float irradiance_at(vec3 position, vec3 normal, vec3 light_position, float radiant_intensity, float source_radius) {
    // Plausible Shading - Measuring Light: I n.l / r^2, r not below the source's radius; 0 behind the surface
    vec3 way = light_position - position;
    float d = length(way), r = max(d, source_radius);
    return d > 0.0 ? radiant_intensity / r * (max(dot(normal, way), 0.0) / d) / r : 0.0;
}

float irradiance_at_naive(vec3 position, vec3 normal, vec3 light_position, float radiant_intensity, float source_radius) {
    // Plausible Shading - Measuring Light: the same, and the cosine is not stopped at 0
    vec3 way = light_position - position;
    float d = length(way), r = max(d, source_radius);
    return d > 0.0 ? radiant_intensity / r * (dot(normal, way) / d) / r : 0.0;
}

float irradiance_directional(float irradiance_facing, float theta) {
    // Punctual Lights - Directional: no distance, only the cosine
    return irradiance_facing * max(cos(theta), 0.0);
}

float falloff_error(float distance, float offset) {
    // Punctual Lights - Directional: 1 - cos^3, what a light at a distance loses sideways; 1 - cos without cancelling
    float x = offset / distance, s = sqrt(1.0 + x * x), q = 1.0 / s;
    return x / s * (x / (1.0 + s)) * (1.0 + q + q * q);
}

float windowed_falloff(float distance, float reach) {
    // Karis 2013, Real Shading in Unreal Engine 4: (1 - (d / R)^4)^2 / (d^2 + 1), multiplied out
    if (distance >= reach) return 0.0;
    float x = distance / reach;
    float window = (reach - distance) / reach * (1.0 + x) * (1.0 + x * x);
    return window * window / (distance * distance + 1.0);
}

float irradiance_windowed(float radiant_intensity, float distance, float theta, float reach) {
    // Karis 2013, Real Shading in Unreal Engine 4
    return radiant_intensity * windowed_falloff(distance, reach) * max(cos(theta), 0.0);
}

float falloff_error_far(float distance, float offset) {
    // Punctual Lights - Directional: the first order of falloff_error
    float x = offset / distance;
    return 1.5 * x * x;
}
