#include "core/constants.glsl"
#include "stage/camera.glsl"
// A vase on the plane z = 0, turned about a vertical axis: the half of it that one sees, by s (around) and u (up).

const float VASE_HEIGHT = 2.1;

float vase_turn(vec2 axis, float s) {
    return atan(camera_position.y - axis.y, camera_position.x - axis.x) + 3.5 * (s - 0.5);
}

vec3 vase_point(vec2 axis, vec2 s) {
    float turn = vase_turn(axis, s.x), r = 0.36 + 0.24 * sin(2.0 * PI * (s.y - 0.08));
    return vec3(axis + r * vec2(cos(turn), sin(turn)), VASE_HEIGHT * s.y);
}

vec3 vase_normal(vec2 axis, vec2 s) {
    float turn = vase_turn(axis, s.x), slope = 0.48 * PI * cos(2.0 * PI * (s.y - 0.08)) / VASE_HEIGHT;
    return normalize(vec3(cos(turn), sin(turn), -slope));
}
