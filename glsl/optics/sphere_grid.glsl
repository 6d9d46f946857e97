#include "core/constants.glsl"
#include "optics/spherical.glsl"

float grid_cell(float theta, int rows) {
    // Basic Concepts: int sin dtheta dphi over the cell of height pi / rows around theta, cut off at the poles
    float high = PI / float(rows);
    float above = min(theta, 0.5 * high), below = min(PI - theta, 0.5 * high);
    return 2.0 * sin(theta + 0.5 * (below - above)) * sin(0.5 * (above + below)) * high;
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
