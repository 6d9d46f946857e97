#include "display/facing.glsl"
#include "optics/spherical.glsl"
// The picked point of a scene whose light and eye are far away: its normal stands theta_v off the line of sight, turned
// about it from upwards to the right. app/brush.py goes the other way, from a normal to the angles.

mat3 picked_frame(float theta_v, float turned) {
    // columns: across the normal towards the eye, along with it right-handed, and the normal
    vec3 side = around(turned), n = cos(theta_v) * eye() + sin(theta_v) * side, x = sin(theta_v) * eye() - cos(theta_v) * side;
    return mat3(x, cross(n, x), n);
}

vec3 picked_light(float theta_l, float theta_v, float phi, float turned) {
    return picked_frame(theta_v, turned) * light_direction(theta_l, phi);
}

// What a file calls X: along growing azimuth about the upward direction, on everything round.
vec3 ball_tangent(vec3 n) { return normalize(cross(up(), n) + 1e-5 * aside()); }

// The same at the picked point, where n is +z and the eye above +x.
vec3 picked_tangent(float theta_v, float turned) {
    return normalize(vec3(-sin(turned), cos(theta_v) * cos(turned), 0.0));
}
