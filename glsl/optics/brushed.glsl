#include "core/constants.glsl"

const float ARC_MINUTE = PI / 10800.0;

float plate_shown(float zoom) {
    // 20 mm fill the picture at first
    return 20.0 / zoom;
}

float grooves_shown(float zoom, float groove_width) {
    // Side by side
    return 1000.0 * plate_shown(zoom) / groove_width;
}

float resolved_distance(float groove_width) {
    // One arc minute is what a sharp eye resolves
    return 1e-4 * groove_width / ARC_MINUTE;
}
