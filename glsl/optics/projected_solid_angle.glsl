#include "core/constants.glsl"
#include "core/disk.glsl"
#include "core/angle.glsl"
#include "optics/solid_angle_flat.glsl"

// Gauss-Legendre, 8 points on [0, 1]
const float GAUSS_AT[8] = float[8](0.0198550718, 0.1016667613, 0.2372337950, 0.4082826788, 0.5917173212, 0.7627662050, 0.8983332387, 0.9801449282);
const float GAUSS_WEIGHT[8] = float[8](0.0506142681, 0.1111905172, 0.1568533229, 0.1813418917, 0.1813418917, 0.1568533229, 0.1111905172, 0.0506142681);

float projected_solid_angle_cone(float half_angle) {
    // Basic Concepts: a cone about the normal; the horizon cuts what is wider than the hemisphere
    float s = sin(min(half_angle, 0.5 * PI));
    return PI * s * s;
}

float projected_solid_angle_sphere(float radius, float distance, float theta) {
    // Snyder 1969, Radiant interchange configuration factors; above the horizon exactly the point light
    float s = radius / distance, mu = cos(theta);
    if (distance < radius) return PI;
    if (distance == radius) return 0.5 * PI * (1.0 + mu);
    if (mu >= s) return PI * mu * s * s;
    if (mu <= -s) return 0.0;
    float z = distance * sqrt((s - mu) * (s + mu) / ((distance - radius) * (distance + radius))), x = z * z;
    float rest = z - arctan2(z, 1.0);
    if (z < 0.4) rest = z * x * (1.0 / 3.0 - x * (1.0 / 5.0 - x * (1.0 / 7.0 - x * (1.0 / 9.0 - x * (1.0 / 11.0 - x * (1.0 / 13.0 - x / 15.0))))));
    return s * s * z - rest + mu * s * s * arctan2(z, -mu);
}

float projected_solid_angle_sphere_naive(float radius, float distance, float theta) {
    // Snyder 1969 as printed, with arcsine and arccosine
    float h = distance / radius, mu = cos(theta), g = sqrt(h * h - 1.0);
    if (distance < radius) return PI;
    if (h * mu >= 1.0) return PI * mu / (h * h);
    if (h * mu <= -1.0) return 0.0;
    float rise = 0.5 * PI - arccos(min(1.0, g / (h * sin(theta))));
    float turn = arccos(clamp(-g * mu / sin(theta), -1.0, 1.0));
    return 0.5 * PI - rise + (mu * turn - g * sqrt(1.0 - h * h * mu * mu)) / (h * h);
}

float projected_solid_angle_disk(float radius, float height, float offset) {
    // Howell, configuration factor of a parallel disk, multiplied out
    vec2 seen = parallel_disk(radius, height, offset);
    return seen.x * seen.y;
}

float projected_solid_angle_disk_naive(float radius, float height, float offset) {
    // Howell, configuration factor of a parallel disk, as printed
    float r2 = radius * radius, h2 = height * height, o2 = offset * offset, sum = h2 + o2 + r2;
    return 0.5 * PI * (1.0 - (h2 + o2 - r2) / sqrt(sum * sum - 4.0 * o2 * r2));
}

float projected_solid_angle_polygon(vec3 corners[MAX_CORNERS], int corner_count) {
    // Lambert 1760, Photometria: the sum around the contour above the horizon; a small polygon by quadrature
    vec3 above[2 * MAX_CORNERS];
    int count = 0;
    for (int i = 0; i < corner_count; i++) {
        vec3 p = corners[i], q = corners[(i + 1) % corner_count];
        if (p.z >= 0.0) above[count++] = p;
        if ((p.z >= 0.0) != (q.z >= 0.0)) above[count++] = vec3((p.xy * q.z - q.xy * p.z) / (q.z - p.z), 0.0);
    }
    if (count < 3) return 0.0;
    float reach = 0.0, near = length(above[0]), sum = 0.0;
    for (int i = 0; i < count; i++) {
        near = min(near, length(above[i]));
        reach = max(reach, length(above[i] - above[0]));
    }
    if (reach < 0.8 * near) {
        for (int i = 2; i < count; i++) {
            vec3 a = above[0], b = above[i - 1] - a, c = above[i] - above[i - 1];
            float part = 0.0;
            for (int j = 0; j < 8; j++) {
                for (int k = 0; k < 8; k++) {
                    vec3 p = a + GAUSS_AT[j] * (b + GAUSS_AT[k] * c);
                    float r2 = dot(p, p);
                    part += GAUSS_WEIGHT[j] * GAUSS_WEIGHT[k] * GAUSS_AT[j] * p.z / (r2 * r2);
                }
            }
            sum += part * dot(a, cross(b, c));
        }
        return abs(sum);
    }
    for (int i = 0; i < count; i++) {
        vec3 p = above[i], q = above[(i + 1) % count], c = cross(p, q - p);
        float size = length(c);
        if (size > 0.0) sum += 0.5 * c.z / size * arctan2(size, dot(p, q));
    }
    return abs(sum);
}

float projected_solid_angle_rectangle(float x0, float x1, float y0, float y1, float distance) {
    // Howell, configuration factor of a parallel rectangle, corner by corner where the axis meets it
    if (x0 * x1 <= 0.0 && y0 * y1 <= 0.0) {
        vec4 x = abs(vec4(x0, x1, x0, x1)), y = abs(vec4(y0, y0, y1, y1));
        float sum = 0.0;
        for (int i = 0; i < 4; i++) {
            float p = length(vec2(x[i], distance)), q = length(vec2(y[i], distance));
            sum += 0.5 * (x[i] / p * arctan2(y[i], p) + y[i] / q * arctan2(x[i], q));
        }
        return sum;
    }
    vec3 corners[MAX_CORNERS];
    corners[0] = vec3(x0, y0, distance);
    corners[1] = vec3(x1, y0, distance);
    corners[2] = vec3(x1, y1, distance);
    corners[3] = vec3(x0, y1, distance);
    return projected_solid_angle_polygon(corners, 4);
}

float projected_solid_angle_wall(float distance, float width, float height) {
    // Howell, configuration factor of a rectangle standing on the surface's plane, its difference multiplied out
    float b = length(vec2(distance, height)), k = height * height / (b + distance);
    return 0.5 * (k / b * arctan2(width, distance) + distance / b * arctan2(width * k, distance * b + width * width));
}
