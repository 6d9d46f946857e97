#include "core/angle.glsl"

float strip_angle(float x, float y0, float y1, float distance) {
    // Urena 2013: the solid angle of the rectangle from 0 to x, y0 to y1, at a distance; negative for x < 0
    float r0 = length(vec2(y0, distance)), r1 = length(vec2(y1, distance)), r = length(vec2(x, distance));
    float k0 = y0 / r0, k1 = y1 / r1, w = x / r, c0 = distance / r0, c1 = distance / r1, c = distance / r;
    float q0 = length(vec2(c, w * c0)), q1 = length(vec2(c, w * c1)); // cosines of asin(k w)
    float rise = y0 * y1 > 0.0 ? c0 * c0 * (y1 - y0) * ((y1 + y0) / (r1 * r1)) / (k1 * q0 + k0 * q1) : k1 * q0 - k0 * q1;
    return arctan2(w * rise, q0 * q1 + k0 * k1 * w * w);
}

float strip_end(float strip, float y0, float y1, float distance) {
    // Urena 2013: the x at which strip_angle has a value, its differences multiplied out
    float r0 = length(vec2(y0, distance)), r1 = length(vec2(y1, distance)), k0 = y0 / r0, k1 = y1 / r1;
    float less = (distance / r0) * (distance / r0) * (y1 - y0) * ((y1 + y0) / (r1 * r1)) / (abs(k1) + abs(k0)); // |k1| - |k0|
    float h = k0 * k1 > 0.0 ? sin(0.5 * strip) : cos(0.5 * strip), w = sin(strip) / sqrt(less * less + 4.0 * abs(k0 * k1) * h * h);
    return distance * w / sqrt(max((1.0 - w) * (1.0 + w), 1e-30));
}

float strip_across(float x, float y0, float y1, float distance, float t) {
    // Urena 2013: y at a given x, so that the sine of its latitude runs evenly from y0 to y1
    float d = length(vec2(x, distance)), e0 = length(vec2(y0, d)), e1 = length(vec2(y1, d));
    vec2 y = abs(vec2(y0, y1)), e = vec2(e0, e1), near = d / e * (d / (e + y)), far = 1.0 + y / e; // 1 - sine and 1 + sine
    vec2 below = vec2(y0 > 0.0 ? near.x : far.x, y1 > 0.0 ? near.y : far.y), above = vec2(y0 > 0.0 ? far.x : near.x, y1 > 0.0 ? far.y : near.y);
    return clamp(d * mix(y0 / e0, y1 / e1, t) / sqrt(mix(below.x, below.y, t) * mix(above.x, above.y, t)), y0, y1);
}

vec3 spherical_rectangle_point(float x0, float x1, float y0, float y1, float distance, float s, float t) {
    // Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles
    float strip = mix(strip_angle(x0, y0, y1, distance), strip_angle(x1, y0, y1, distance), s);
    float x = clamp(strip_end(strip, y0, y1, distance), x0, x1);
    return vec3(x, strip_across(x, y0, y1, distance, t), distance);
}
