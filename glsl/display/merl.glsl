#include "core/constants.glsl"
#include "core/angle.glsl"
// A measurement of the MERL database as a table of 2160 columns, its numbers in the order of the file: what
// app/board/merl.py computes in float64, from the middle of one cell to the middle of the next.

float merl_cell(sampler2D cells, int channel, ivec3 at) {
    int index = ((channel * 90 + at.x) * 90 + at.y) * 180 + at.z;
    return texelFetch(cells, ivec2(index % 2160, index / 2160), 0).r;
}

vec3 merl_value(sampler2D cells, vec3 n, vec3 l, vec3 v) {
    // Rusinkiewicz 1998: the halfway vector, and the light as it sees it
    vec3 h = normalize(l + v + 1e-7 * n), flat_h = h - dot(n, h) * n;
    float sine = length(flat_h), up = dot(n, h);
    vec3 radial = sine > 1e-6 ? flat_h / sine : normalize(abs(n.z) < 0.9 ? cross(n, vec3(0.0, 0.0, 1.0)) : cross(n, vec3(1.0, 0.0, 0.0)));
    float y = dot(l, cross(n, radial)), x = dot(l, up * radial - sine * n);
    vec3 at = vec3(90.0 * sqrt(2.0 / PI * arctan2(sine, up)) - 0.5, 180.0 / PI * arctan2(length(vec2(x, y)), dot(l, h)) - 0.5,
        180.0 / PI * arctan2(y, x) - 0.5);
    at = vec3(clamp(at.xy, 0.0, 89.0), at.z - 180.0 * floor(at.z / 180.0));
    ivec3 low = min(ivec3(at), ivec3(89, 89, 179)), high = ivec3(min(low.xy + 1, 89), (low.z + 1) % 180);
    vec3 share = at - vec3(low), total = vec3(0.0), weight = vec3(0.0);
    for (int corner = 0; corner < 8; corner++) {
        bvec3 end = bvec3((corner & 1) == 1, (corner & 2) == 2, (corner & 4) == 4);
        ivec3 cell = ivec3(end.x ? high.x : low.x, end.y ? high.y : low.y, end.z ? high.z : low.z);
        vec3 w = vec3(end.x ? share.x : 1.0 - share.x, end.y ? share.y : 1.0 - share.y, end.z ? share.z : 1.0 - share.z);
        vec3 f = vec3(merl_cell(cells, 0, cell), merl_cell(cells, 1, cell), merl_cell(cells, 2, cell));
        vec3 measured = w.x * w.y * w.z * step(vec3(0.0), f); // below 0 nothing was measured
        total += measured * f;
        weight += measured;
    }
    return vec3(1.0, 1.15, 1.66) / 1500.0 * total / max(weight, vec3(1e-20));
}
