#include "stage/camera.glsl"

// The half of a unit ball that the eye sees, out to its limb: nothing is coloured twice, and its outline is round.
vec3 facing_ball(vec2 st, vec3 centre, float radius) {
    vec3 towards = camera_position - centre, pole = normalize(towards);
    vec3 side = normalize(cross(vec3(0.001, 0.0, 1.0), pole)), up = cross(pole, side);
    float limb = acos(min(radius / length(towards), 1.0)), off = limb * st.y, turn = 6.28318531 * st.x;
    return centre + radius * (cos(off) * pole + sin(off) * (cos(turn) * side + sin(turn) * up));
}
