#include "core/constants.glsl"
#include "core/ball.glsl"

const vec3 BALL = vec3(1.1, 0.0, 0.5);
const float BALL_RADIUS = 0.3;
const int WALL_CELLS = 10;

float irradiance_floor_local(float from_wall, float along_wall, float lamp_x, float lamp_height, float radiant_intensity) {
    // Local Shading Models: the lamp alone
    vec3 way = vec3(from_wall - lamp_x, along_wall, lamp_height);
    float r2 = dot(way, way);
    return radiant_intensity * lamp_height / (r2 * sqrt(r2));
}

float irradiance_floor_shadowed(float from_wall, float along_wall, float lamp_x, float lamp_height, float radiant_intensity) {
    // Local Shading Models: the lamp, where the ball lets it through
    float seen = seen_past_ball(vec3(from_wall, along_wall, 0.0), vec3(lamp_x, 0.0, lamp_height), BALL, BALL_RADIUS);
    return seen * irradiance_floor_local(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity);
}

float irradiance_floor_bounced(float from_wall, float along_wall, float lamp_x, float lamp_height, float radiant_intensity, float rho) {
    // Wallace, Elmquist and Haines 1989: each cell of the wall as a disk that faces the point
    vec3 point = vec3(from_wall, along_wall, 0.0), lamp = vec3(lamp_x, 0.0, lamp_height);
    float wide = 2.0 / float(WALL_CELLS), area = wide * wide, total = 0.0;
    for (int i = 0; i < WALL_CELLS; i++) {
        for (int j = 0; j < WALL_CELLS; j++) {
            vec3 cell = vec3(0.0, wide * (float(i) + 0.5) - 1.0, wide * (float(j) + 0.5));
            vec3 to_lamp = lamp - cell, to_cell = cell - point;
            float l2 = dot(to_lamp, to_lamp), r2 = dot(to_cell, to_cell);
            float light = to_lamp.x / (l2 * sqrt(l2)) * seen_past_ball(cell, lamp, BALL, BALL_RADIUS);
            total += light * seen_past_ball(point, cell, BALL, BALL_RADIUS) * to_cell.z * point.x / (r2 * (r2 + area / PI));
        }
    }
    return rho / PI * radiant_intensity * area * total;
}

float irradiance_floor(float from_wall, float along_wall, float lamp_x, float lamp_height, float radiant_intensity, float rho) {
    // Wallace, Elmquist and Haines 1989: the lamp's light and one reflection by the wall
    return irradiance_floor_shadowed(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity)
        + irradiance_floor_bounced(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity, rho);
}

float interreflection_gain(float rho) {
    // Ulbricht 1900, the integrating sphere: 1 + rho + rho^2 + ...
    return 1.0 / (1.0 - rho);
}
