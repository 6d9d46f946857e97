#include "stage/camera.glsl"
// The frame of someone who looks at the middle of the scene: to the eye, upwards and to the right.

vec3 eye() { return normalize(camera_position); }

vec3 up() { return normalize(vec3(0.0, 0.0, 1.0) - eye().z * eye()); }

vec3 aside() { return cross(up(), eye()); }

vec3 around(float turn) { return cos(turn) * up() + sin(turn) * aside(); } // clockwise, from up
