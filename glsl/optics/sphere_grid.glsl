#include "core/constants.glsl"
#include "optics/spherical.glsl"

float grid_cell(float theta, int rows) {
    // Basic Concepts: int sin dtheta dphi over the cell of height pi / rows around theta, cut off at the poles
    float high = PI / float(rows);
    float top = max(theta - 0.5 * high, 0.0), bottom = min(theta + 0.5 * high, PI);
    return 2.0 * sin(0.5 * (top + bottom)) * sin(0.5 * (bottom - top)) * high;
}

float grid_cell_differential(float theta, int rows) {
    // Basic Concepts: sin dtheta dphi
    float high = PI / float(rows);
    return sin(theta) * high * high;
}

float grid_cell_widest(int rows) {
    // Basic Concepts: theta of the middle of the row with the largest cells, the upper one of two
    float high = PI / float(rows);
    return (float((rows - 1) / 2) + 0.5) * high;
}
