#include "core/constants.glsl"
#include "core/power.glsl"
#include "core/angle.glsl"
#include "optics/spherical.glsl"
#include "optics/beckmann.glsl"

float facet_slope(int index, float m, int facets) {
    // Beckmann's distribution at the quantile (index + 1/2) / facets
    float share = (float(index) + 0.5) / float(facets), rest = (float(facets - index) - 0.5) / float(facets);
    return m * sqrt(-(share < 0.5 ? log_one_less(share) : log(rest)));
}

vec3 facet_normal(int index, float m, int facets) {
    // Vogel 1979: azimuths in golden turns, in 32-bit integers
    float turn = 2.0 * PI * (float(int(uint(index) * 2654435769u)) / 4294967296.0), t = facet_slope(index, m, facets);
    return vec3(t * cos(turn), t * sin(turn), 1.0) / length(vec2(1.0, t));
}

float facet_index(int place, int facets) {
    // A multiplicative shuffle
    return float(place * 16183 % facets);
}

float facets_lit(float theta_l, float theta_v, float phi, float m, float half_angle, int facets) {
    // The Torrance - Sparrow Microfacet Model (2): only facets with m = h, as the lamp is round m near h
    vec3 h = light_direction(theta_l, phi) + view_direction(theta_v);
    h /= max(length(h), 1e-30);
    float lit = 0.0, near = 2.0 * sin(0.5 * half_angle);
    for (int i = 0; i < facets; i++) lit += distance(facet_normal(i, m, facets), h) <= near ? 1.0 : 0.0;
    return lit;
}

float halfway_angle(float theta_l, float theta_v, float phi) {
    // The Blinn Model: between n and h
    vec3 s = light_and_view(theta_l, theta_v, phi);
    return arctan2(length(s.xy), s.z);
}

float d_near(float theta_l, float theta_v, float phi, float m, float half_angle, int facets) {
    // Distribution Term (1): the facets towards h, over the projected solid angle of their cone
    float s = sin(half_angle), cone = PI * s * s * cos(halfway_angle(theta_l, theta_v, phi));
    return facets_lit(theta_l, theta_v, phi, m, half_angle, facets) / (float(facets) * cone);
}

float d_halfway(float theta_l, float theta_v, float phi, float m) {
    // Distribution Term (2): Beckmann's at h
    return d_beckmann(vec3(0.0, 0.0, 1.0), light_and_view(theta_l, theta_v, phi), m);
}

float d_counted(float theta_h, float m, float half_angle, int facets) {
    // Distribution Term (1): the facets of a ring, over its projected solid angle
    float low = max(theta_h - half_angle, 0.0), high = min(theta_h + half_angle, 0.5 * PI), count = 0.0;
    for (int i = 0; i < facets; i++) {
        float angle = arctan2(facet_slope(i, m, facets), 1.0);
        count += angle >= theta_h - half_angle && angle < theta_h + half_angle ? 1.0 : 0.0;
    }
    return count / (float(facets) * PI * sin(high - low) * sin(high + low));
}
