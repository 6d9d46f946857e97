#include "stage/camera.glsl"
#include "core/constants.glsl"
// A ball is cheap as the part of it one sees: a cap of few cells towards the eye, and the true sphere at each pixel.

vec3 cap_to_eye(vec2 st, vec3 centre, float radius) {
    vec3 to_eye = camera_position - centre;
    float far = length(to_eye), angle = st.y * acos(min(radius / far, 1.0)), turn = 2.0 * PI * st.x;
    vec3 w = to_eye / far, u = normalize(abs(w.z) < 0.9 ? vec3(-w.y, w.x, 0.0) : vec3(0.0, -w.z, w.y));
    return centre + radius * (cos(angle) * w + sin(angle) * (cos(turn) * u + sin(turn) * cross(w, u)));
}

// The normal where the ray to the eye meets the unit sphere, from any point on that ray, relative to the centre.
vec3 ball_normal(vec3 point, vec3 v) {
    float b = dot(point, v);
    return point + (sqrt(max(1.0 + b * b - dot(point, point), 0.0)) - b) * v;
}

// Many balls on one grid of cells, of 33 columns each: 30 around and a point on either side, so that a line joins two.
const int BALL_COLUMNS = 33;

int ball_number(vec2 st, int count) {
    return min(int((st.x * float(BALL_COLUMNS * count - 1) + 0.5) / float(BALL_COLUMNS)), count - 1);
}

vec3 ball_point(vec2 st, int count, vec3 centre, float radius) {
    int column = int(st.x * float(BALL_COLUMNS * count - 1) + 0.5) % BALL_COLUMNS;
    bool joint = column == 0 || column == BALL_COLUMNS - 1;
    return cap_to_eye(vec2(float(column - 1) / float(BALL_COLUMNS - 3), joint ? 0.0 : st.y), centre, radius);
}
