#include "display/studio.glsl"

const float ROOM_SLOPES[4] = float[4](0.3654, 0.6856, 0.9904, 1.4420); // Beckmann's, over m: each as likely

// The studio, mirrored in 20 rough facets that reflect all: with the V-grooves' share of them, or (grooves false) as a
// normalised Blinn-Phong lobe has it. A look; smooth enough to be computed at corners.
vec3 rough_room(vec3 n, vec3 v, float m, bool grooves) {
    float n_dot_v = max(dot(n, v), 0.02);
    vec3 x = normalize(abs(n.z) < 0.9 ? vec3(-n.y, n.x, 0.0) : vec3(0.0, -n.z, n.y)), y = cross(n, x), sum = vec3(0.0);
    for (int i = 0; i < 20; i++) {
        float turn = 1.25663706 * (float(i / 4) + 0.25 * float(i % 4)), slope = m * ROOM_SLOPES[i % 4];
        vec3 h = normalize(n + slope * (cos(turn) * x + sin(turn) * y)), l = reflect(-v, h);
        float u = dot(v, h), n_dot_l = dot(n, l), n_dot_h = dot(n, h);
        if (u <= 0.0 || n_dot_l <= 0.0) continue;
        float share = grooves ? min(u, 2.0 * n_dot_h * min(n_dot_v, n_dot_l)) / n_dot_v : u * n_dot_l;
        sum += studio(l) * (share / (20.0 * n_dot_h));
    }
    return sum;
}
