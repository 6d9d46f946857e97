#include "core/constants.glsl"
#include "core/angle.glsl"
#include "core/elliptic.glsl"

float solid_angle_cone(float half_angle) {
    // Solid Angles: the area a cone cuts out of the unit sphere
    float s = sin(0.5 * half_angle);
    return 4.0 * PI * s * s;
}

float solid_angle_cone_naive(float half_angle) {
    // Solid Angles, as textbooks print it: 1 - cos loses every digit of a narrow cone
    return 2.0 * PI * (1.0 - cos(half_angle));
}

float solid_angle_sphere(float radius, float distance) {
    // Solid Angles: the cone that touches the sphere, sin(half_angle) = radius / distance
    if (distance < radius) return 4.0 * PI;
    float s = radius / distance;
    float q = sqrt((distance - radius) * (distance + radius)) / distance;
    return 2.0 * PI * s * s / (1.0 + q);
}

float solid_angle_sphere_naive(float radius, float distance) {
    // Solid Angles, as textbooks print it: the difference loses every digit of a far sphere
    if (distance < radius) return 4.0 * PI;
    float s = radius / distance;
    return 2.0 * PI * (1.0 - sqrt(1.0 - s * s));
}

float solid_angle_disk_on_axis(float radius, float height) {
    // Solid Angles: the cone through the rim, 1 - cos multiplied out
    float q = length(vec2(height, radius));
    return 2.0 * PI * (radius / q) * (radius / (q + abs(height)));
}

float solid_angle_disk_on_axis_naive(float radius, float height) {
    // Solid Angles, as textbooks print it
    return 2.0 * PI * (1.0 - abs(height) / length(vec2(height, radius)));
}

float solid_angle_disk(float radius, float height, float offset) {
    // Paxton 1959, Solid Angle Calculation for a Circular Disk; far away the multipole series
    float h = abs(height), far = length(vec2(height, offset)), inner = radius - offset;
    if (far > 2.0 * radius) {
        float c = h / far, x = (radius / far) * (radius / far);
        float sum = 0.0, scale = 0.5 * x, before = 1.0, legendre = c; // P_0 and P_1 of c
        for (int k = 1; k <= 13; k++) {
            float n = 2.0 * float(k);
            sum += scale * legendre;
            scale *= -x * (n + 1.0) / (n + 2.0);
            before = ((2.0 * n - 1.0) * c * legendre - (n - 1.0) * before) / n;
            legendre = ((2.0 * n + 1.0) * c * before - n * legendre) / (n + 1.0);
        }
        return 2.0 * PI * sum;
    }
    float reach = length(vec2(height, radius + offset)), k_c = length(vec2(height, inner)) / reach;
    if (h == 0.0) return inner > 0.0 ? 2.0 * PI : inner < 0.0 ? 0.0 : PI;
    if (inner == 0.0) return PI - 2.0 * h / reach * complete_elliptic(k_c, 1.0, 1.0, 1.0);
    float q = inner / (radius + offset);
    float part = 2.0 * h / reach * complete_elliptic(k_c, abs(q), 1.0 + q, q + q * q);
    return (inner > 0.0 ? 2.0 * PI : 0.0) - part;
}

float solid_angle_cell(float theta, float d_theta, float d_phi) {
    // Solid Angles: the integral of sin(theta) over a cell centred at theta
    return 2.0 * sin(theta) * sin(0.5 * d_theta) * d_phi;
}

float solid_angle_cell_differential(float theta, float d_theta, float d_phi) {
    // Solid Angles: sin(theta) d_theta d_phi
    return sin(theta) * d_theta * d_phi;
}

float solid_angle_cells(int rows) {
    // Solid Angles: sin(theta) d_theta d_phi summed over rows x 2 rows cells; the sum of sines in closed form
    float half_step = 0.5 * PI / float(rows);
    return 4.0 * PI * half_step / sin(half_step);
}
