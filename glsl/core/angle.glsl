#include "core/constants.glsl"

// The built-in atan may err by 2e-5 (Mesa) or 4096 ulp (Vulkan); these err by at most 3 ulp.

float arctan2(float y, float x) {
    // Cephes, atanf.c: reduced to [-tan(pi/8), tan(pi/8)], odd polynomial. arctan2(0, 0) = 0.
    float low = min(abs(x), abs(y)), high = max(abs(x), abs(y));
    if (high == 0.0) return 0.0;
    bool far = low > 0.41421356 * high;
    float r = far ? (low - high) / (low + high) : low / high, z = r * r;
    float angle = r + r * z * (((0.0805374449538 * z - 0.138776856032) * z + 0.199777106478) * z - 0.333329491539);
    if (far) angle += 0.25 * PI;
    if (abs(y) > abs(x)) angle = 0.5 * PI - angle;
    if (x < 0.0) angle = PI - angle;
    return y < 0.0 ? -angle : angle;
}

float arccos(float x) {
    return arctan2(sqrt(max(0.0, (1.0 - x) * (1.0 + x))), x);
}

float sine_of(float angle) {
    // Taylor series, between -pi/2 and pi/2 to 1e-9: less work for a processor than the built-in sine
    float x = angle * angle;
    return angle * (1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0 * (1.0 - x / 156.0))))));
}
