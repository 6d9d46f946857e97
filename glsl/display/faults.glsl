// What must never be hidden: x counts NaN, y Inf, z negative radiance.
vec3 faults(vec3 radiance) {
    bool not_a_number = any(isnan(radiance));
    bool infinite = any(isinf(radiance));
    bool negative = any(lessThan(radiance, vec3(0.0)));
    return vec3(not_a_number ? 1.0 : 0.0, infinite ? 1.0 : 0.0, negative ? 1.0 : 0.0);
}

vec3 fault_colour(vec3 found, vec2 pixel) {
    // A pattern and a colour: magenta checkerboard NaN, cyan stripes Inf, red dots negative.
    if (found.x > 0.0) return mod(floor(pixel.x / 6.0) + floor(pixel.y / 6.0), 2.0) < 1.0 ? vec3(1.0, 0.0, 1.0) : vec3(0.0);
    if (found.y > 0.0) return mod(floor((pixel.x + pixel.y) / 6.0), 2.0) < 1.0 ? vec3(0.0, 1.0, 1.0) : vec3(0.0);
    return length(mod(pixel, 8.0) - 4.0) < 3.0 ? vec3(1.0, 0.0, 0.0) : vec3(0.2, 0.0, 0.0);
}
