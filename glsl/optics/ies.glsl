#include "core/constants.glsl"
#include "core/angle.glsl"

vec3 ies_place(sampler2D table, int row, float angle) {
    // IES LM-63-2002: the angle below, and the weights of it and of the next; -1 outside the measured range
    int low = 0, high = int(texelFetch(table, ivec2(row, 0), 0).x) - 1;
    float a = texelFetch(table, ivec2(low, row), 0).x, b = texelFetch(table, ivec2(high, row), 0).x;
    if (!(angle >= a - 1e-4 && angle <= b + 1e-4)) return vec3(-1.0, 0.0, 0.0);
    int guess = clamp(int((angle - a) / (b - a) * float(high)), 0, high - 1); // right where the angles are even
    float c = texelFetch(table, ivec2(guess, row), 0).x, d = texelFetch(table, ivec2(guess + 1, row), 0).x;
    if (c <= angle && angle <= d) {
        low = guess;
        high = guess + 1;
        a = c;
        b = d;
    }
    while (high - low > 1) { // a counted loop would be unrolled, and run to its end by every pixel of a CPU
        int middle = (low + high) / 2;
        float m = texelFetch(table, ivec2(middle, row), 0).x;
        if (m <= angle) {
            low = middle;
            a = m;
        } else {
            high = middle;
            b = m;
        }
    }
    return vec3(float(low), clamp(vec2(b - angle, angle - a) / (b - a), 0.0, 1.0));
}

float ies_candela(sampler2D table, float theta, float phi) {
    // IES LM-63-2002: bilinear between the measured angles, 0 outside them
    if (texelFetch(table, ivec2(0, 0), 0).x > 0.5) { // type B: the pole is horizontal
        float down = cos(theta), front = sin(theta) * cos(phi), side = sin(theta) * sin(phi);
        theta = arctan2(length(vec2(down, front)), -side);
        phi = arctan2(front, down);
    }
    vec3 p = ies_place(table, 1, theta * (180.0 / PI)), q = ies_place(table, 2, phi * (180.0 / PI));
    if (p.x < 0.0 || q.x < 0.0) return 0.0;
    int i = int(p.x), j = int(q.x);
    float lower = texelFetch(table, ivec2(i, j + 3), 0).x * p.y + texelFetch(table, ivec2(i + 1, j + 3), 0).x * p.z;
    float upper = texelFetch(table, ivec2(i, j + 4), 0).x * p.y + texelFetch(table, ivec2(i + 1, j + 4), 0).x * p.z;
    return lower * q.y + upper * q.z;
}

float ies_ring_flux(float theta, float d_theta, float candela_below, float candela_above) {
    // optics reference 7.8: 2 pi int (p + q t) sin t over a ring, in a form that does not cancel
    float h = 0.5 * d_theta, x = h * h;
    float series = 1.0 - x / 10.0 * (1.0 - x / 28.0 * (1.0 - x / 54.0 * (1.0 - x / 88.0 * (1.0 - x / 130.0))));
    float even = sin(theta) * sin(h), odd = cos(theta) * (x / 3.0 * series);
    return 2.0 * PI * ((candela_below + candela_above) * even + (candela_above - candela_below) * odd);
}

float ies_flux(sampler2D table) {
    // optics reference 7.8: the rings between the angles from the pole, each with its mean over the azimuths
    int n = int(texelFetch(table, ivec2(1, 0), 0).x), planes = int(texelFetch(table, ivec2(2, 0), 0).x);
    float sum = 0.0, before = 0.0, angle = 0.0;
    for (int i = 0; i < n; i++) {
        float ring = 0.0, t = texelFetch(table, ivec2(i, 1), 0).x;
        for (int j = 1; j < planes; j++) {
            float wide = texelFetch(table, ivec2(j, 2), 0).x - texelFetch(table, ivec2(j - 1, 2), 0).x;
            ring += wide / 720.0 * (texelFetch(table, ivec2(i, j + 2), 0).x + texelFetch(table, ivec2(i, j + 3), 0).x);
        }
        if (i > 0) {
            sum += ies_ring_flux((t + angle) * (PI / 360.0), (t - angle) * (PI / 180.0), before, ring);
        }
        before = ring;
        angle = t;
    }
    return sum;
}

float ies_declared(sampler2D table) {
    // IES LM-63-2002: lamps times lumens per lamp; NaN for absolute photometry
    return texelFetch(table, ivec2(3, 0), 0).x;
}

float ies_peak(sampler2D table) {
    // IES LM-63-2002: the largest candela
    return texelFetch(table, ivec2(4, 0), 0).x;
}

float ies_lumens(sampler2D table) {
    // optics reference 7.8: the integrated flux, summed once when the table is made
    return texelFetch(table, ivec2(5, 0), 0).x;
}

vec3 ies_solid(sampler2D table, float s, float t) {
    // IES Lights: in each direction as far out as the intensity, the peak being 1
    float theta = PI * t, phi = 2.0 * PI * (s > 0.5 ? s - 1.0 : s);
    vec3 way = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta));
    return way * (ies_candela(table, theta, phi) / ies_peak(table));
}

float ies_solid_candela(sampler2D table, float s, float t) {
    // IES Lights: the intensity at a point of the solid
    return ies_candela(table, PI * t, 2.0 * PI * (s > 0.5 ? s - 1.0 : s));
}

float ies_plane(sampler2D table, float theta, float plane) {
    // IES Lights: a photometric plane, and over the nadir its opposite half
    return ies_candela(table, abs(theta), theta < 0.0 ? plane - PI : plane);
}

float ies_as_spot(sampler2D table, float off_axis, float hotspot, float falloff) {
    // IES Lights, Spotlights: the measured intensity as a share of that of a spot of the same flux
    float inner = sin(0.5 * min(hotspot, falloff)), outer = sin(0.5 * falloff);
    return ies_candela(table, off_axis, 0.0) * (2.0 * PI * (inner * inner + outer * outer) / ies_lumens(table));
}

float ies_towards(sampler2D table, vec3 way, float turn, float aim) {
    // IES Lights: the way to the point turned back into the luminaire's own frame
    float front = way.x * cos(turn) + way.y * sin(turn), side = way.y * cos(turn) - way.x * sin(turn);
    float ahead = front * cos(aim) + way.z * sin(aim), up = way.z * cos(aim) - front * sin(aim);
    return ies_candela(table, arctan2(length(vec2(ahead, side)), -up), arctan2(side, ahead));
}

float ies_illuminance(sampler2D table, vec3 way, vec3 normal, float turn, float aim) {
    // Units for Lighting: I cos / r^2
    float r = length(way), facing = -dot(way, normal);
    return facing > 0.0 ? ies_towards(table, way, turn, aim) * facing / (r * r * r) : 0.0;
}

float ies_room_illuminance(sampler2D table, float height, float setback, float turn, float aim, float meter_x, float meter_s) {
    // IES Lights: the meter on the floor (meter_s <= 0) or up the wall; the luminaire faces the wall at turn 0
    vec3 way = vec3(min(meter_s, 0.0) + setback, -meter_x, max(meter_s, 0.0) - height);
    vec3 normal = meter_s > 0.0 ? vec3(-1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
    return ies_illuminance(table, way, normal, turn, aim);
}
