#include "core/constants.glsl"

vec2 parallel_disk(float radius, float height, float offset) {
    // Two factors of the projected solid angle of a disk seen from a plane parallel to it: their product may be smaller
    // than float32's smallest number where a radiance makes it an ordinary one
    float z = height * height + (offset - radius) * (offset + radius), s = length(vec2(z, 2.0 * radius * height));
    return z > 0.0 ? vec2(2.0 * PI * radius * height / s, radius * height / (s + z)) : vec2(0.5 * PI, (s - z) / s);
}
