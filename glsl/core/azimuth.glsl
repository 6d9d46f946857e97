#include "core/angle.glsl"

vec2 azimuths_between(float near, float wide, float low, float high) {
    // The azimuths from 0 to pi at which near + wide cos phi lies between two values: how many, and the integral of cos phi
    float from = arccos(clamp((max(high, low) - near) / wide, -1.0, 1.0)), to = arccos(clamp((low - near) / wide, -1.0, 1.0));
    return vec2(to - from, sin(to) - sin(from));
}
