#include "core/angle.glsl"

float strip_angle(float x, float y0, float y1, float distance) {
    // Urena 2013: the solid angle of the rectangle from 0 to x, y0 to y1, at a distance; negative for x < 0
    float r0 = length(vec2(y0, distance)), r1 = length(vec2(y1, distance)), r = length(vec2(x, distance));
    float k0 = y0 / r0, k1 = y1 / r1, w = x / r, c0 = distance / r0, c1 = distance / r1, c = distance / r;
    float q0 = length(vec2(c, w * c0)), q1 = length(vec2(c, w * c1)); // cosines of asin(k w)
    float rise = y0 * y1 > 0.0 ? c0 * c0 * (y1 - y0) * ((y1 + y0) / (r1 * r1)) / (k1 * q0 + k0 * q1) : k1 * q0 - k0 * q1;
    return arctan2(w * rise, q0 * q1 + k0 * k1 * w * w);
}

vec3 spherical_rectangle_point(float x0, float x1, float y0, float y1, float distance, float s, float t) {
    // Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles, its differences multiplied out
    float a = mix(strip_angle(x0, y0, y1, distance), strip_angle(x1, y0, y1, distance), s);
    float r0 = length(vec2(y0, distance)), r1 = length(vec2(y1, distance)), k0 = y0 / r0, k1 = y1 / r1;
    float less = (distance / r0) * (distance / r0) * (y1 - y0) * ((y1 + y0) / (r1 * r1)) / (abs(k1) + abs(k0)); // |k1| - |k0|
    float h = k0 * k1 > 0.0 ? sin(0.5 * a) : cos(0.5 * a), w = sin(a) / sqrt(less * less + 4.0 * abs(k0 * k1) * h * h);
    float x = clamp(distance * w / sqrt(max((1.0 - w) * (1.0 + w), 1e-30)), x0, x1);
    float d = length(vec2(x, distance)), e0 = length(vec2(y0, d)), e1 = length(vec2(y1, d));
    float up = y1 > 0.0 ? d / e1 * (d / (e1 + y1)) : 1.0 - y1 / e1, up0 = y0 > 0.0 ? d / e0 * (d / (e0 + y0)) : 1.0 - y0 / e0;
    float down = y1 < 0.0 ? d / e1 * (d / (e1 - y1)) : 1.0 + y1 / e1, down0 = y0 < 0.0 ? d / e0 * (d / (e0 - y0)) : 1.0 + y0 / e0;
    float v = mix(y0 / e0, y1 / e1, t), y = d * v / sqrt(mix(up0, up, t) * mix(down0, down, t));
    return vec3(x, clamp(y, y0, y1), distance);
}
