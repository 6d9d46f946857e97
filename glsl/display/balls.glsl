#include "optics/spherical.glsl"
// Many unit spheres on one grid of cells, 25 columns each: columns between two of them shrink to a line.

int ball_number(vec2 st, int count) {
    return min(int(floor((st.x * float(25 * count - 1) + 0.5) / 25.0)), count - 1);
}

vec3 ball_point(vec2 st, int count) {
    int column = int(st.x * float(25 * count - 1) + 0.5);
    return sphere_point(st.y, float(column - 25 * (column / 25)) / 24.0);
}
