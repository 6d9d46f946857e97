#include "core/constants.glsl"
#include "optics/spherical.glsl"
#include "optics/solid_angle_flat.glsl"
#include "optics/projected_solid_angle.glsl"

vec3 patch_point(float theta, float phi, float distance, float tilt, float width, float s, float t) {
    // Solid Angles: the square over (s, t), its centre in the direction (theta, phi), turned about a horizontal axis
    vec3 outward = direction(theta, phi), down = direction_theta(theta, phi), side = direction_phi(phi);
    return distance * outward + width * ((s - 0.5) * side + (t - 0.5) * (cos(tilt) * down + sin(tilt) * outward));
}

vec3 patch_normal(float theta, float phi, float tilt) {
    // Solid Angles: towards the eye at tilt 0, down to the base plane at tilt pi/2
    return sin(tilt) * direction_theta(theta, phi) - cos(tilt) * direction(theta, phi);
}

float solid_angle_patch(float distance, float tilt, float width) {
    // Solid Angles: in the square's own plane, where the eye is over the square or beside it
    float slide = abs(distance * sin(tilt)), height = abs(distance * cos(tilt)), h = 0.5 * width;
    if (slide <= h) return solid_angle_rectangle_off_axis(-h, h, slide - h, slide + h, height);
    return 2.0 * solid_angle_rectangle_beside(slide - h, slide + h, width, h, height);
}

float solid_angle_patch_small(float distance, float tilt, float width) {
    // Solid Angles: dA cos / r^2
    float seen = width / distance;
    return seen * seen * abs(cos(tilt));
}

float meets_patch(vec3 towards, float theta, float phi, float distance, float tilt, float width) {
    // Solid Angles: 1 where the ray from the eye meets the square, else 0
    vec3 down = direction_theta(theta, phi), side = direction_phi(phi);
    float along = dot(towards, direction(theta, phi)), fall = dot(towards, down);
    float way = distance * cos(tilt) / (along * cos(tilt) - fall * sin(tilt)); // to the square's plane
    float x = way * dot(towards, side), y = way * (fall * cos(tilt) + along * sin(tilt)) - distance * sin(tilt);
    return way > 0.0 && max(abs(x), abs(y)) <= 0.5 * width ? 1.0 : 0.0;
}

float solid_angle_patch_ratio(float distance, float tilt, float width) {
    // Solid Angles: what is left twice as far away
    return solid_angle_patch(2.0 * distance, tilt, width) / solid_angle_patch(distance, tilt, width);
}

float solid_angle_patch_counted(float theta, float phi, float distance, float tilt, float width, int samples) {
    // Solid Angles: 4 pi times the share of evenly spread directions that meet the square
    float hits = 0.0;
    for (int i = 0; i < samples; i++) hits += meets_patch(fibonacci_direction(i, samples), theta, phi, distance, tilt, width);
    return 4.0 * PI * hits / float(samples);
}

float solid_angle_patch_counted_naive(float theta, float phi, float distance, float tilt, float width, int samples) {
    // Solid Angles, without sin theta: directions in equal steps of the polar angle
    float hits = 0.0;
    for (int i = 0; i < samples; i++) hits += meets_patch(fibonacci_direction_naive(i, samples), theta, phi, distance, tilt, width);
    return 4.0 * PI * hits / float(samples);
}

float projected_solid_angle_patch(float theta, float distance, float tilt, float width) {
    // Basic Concepts: the square's shadow on the base disk, cut at the horizon; a small one above it by quadrature
    vec3 centre = distance * direction(theta, 0.0), side = width * direction_phi(0.0);
    vec3 along = width * (cos(tilt) * direction_theta(theta, 0.0) + sin(tilt) * direction(theta, 0.0));
    if (centre.z > 0.5 * abs(along.z) && width < 0.4 * distance) {
        float sum = 0.0;
        for (int j = 0; j < 8; j++) {
            for (int k = 0; k < 8; k++) {
                vec3 p = centre + (GAUSS_AT[j] - 0.5) * side + (GAUSS_AT[k] - 0.5) * along;
                float r2 = dot(p, p);
                sum += GAUSS_WEIGHT[j] * GAUSS_WEIGHT[k] * p.z / (r2 * r2);
            }
        }
        return sum * width * width * distance * abs(cos(tilt));
    }
    vec3 corners[MAX_CORNERS];
    corners[0] = patch_point(theta, 0.0, distance, tilt, width, 0.0, 0.0);
    corners[1] = patch_point(theta, 0.0, distance, tilt, width, 1.0, 0.0);
    corners[2] = patch_point(theta, 0.0, distance, tilt, width, 1.0, 1.0);
    corners[3] = patch_point(theta, 0.0, distance, tilt, width, 0.0, 1.0);
    return projected_solid_angle_polygon(corners, 4);
}

float projected_solid_angle_patch_small(float theta, float distance, float tilt, float width) {
    // Basic Concepts: dA cos / r^2 times the cosine at the surface
    return solid_angle_patch_small(distance, tilt, width) * max(0.0, cos(theta));
}
