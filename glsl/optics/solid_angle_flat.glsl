#include "core/constants.glsl"
#include "core/angle.glsl"

float solid_angle_rectangle(float width, float depth, float distance) {
    // Solid Angles: a rectangle facing the eye, its centre on the axis
    float diagonal = length(vec3(2.0 * distance, width, depth));
    return 4.0 * arctan2(width * depth, 2.0 * distance * diagonal);
}

float solid_angle_rectangle_naive(float width, float depth, float distance) {
    // Solid Angles, the arccos form: its argument is 1 for a far rectangle
    float a = width / (2.0 * distance), b = depth / (2.0 * distance);
    return 4.0 * arccos(sqrt((1.0 + a * a + b * b) / ((1.0 + a * a) * (1.0 + b * b))));
}

float solid_angle_corners(vec3 a, vec3 b, vec3 c, vec3 area) {
    // van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle; area = (b - a) x (c - a)
    float x = length(a), y = length(b), z = length(c), size = x * y * z;
    vec3 nearest = x <= y && x <= z ? a : y <= z ? b : c;
    float volume = dot(nearest, area);
    if (volume == 0.0 || size == 0.0) return 0.0; // the eye is in the triangle's plane
    vec3 p = a / x + b / y, q = b / y + c / z, r = c / z + a / x;
    float pp = dot(p, p), qq = dot(q, q), rr = dot(r, r);
    float spread = pp >= max(qq, rr) ? dot(q, r) : qq >= rr ? dot(p, r) : dot(p, q); // all are 1 + cos + cos + cos
    return 2.0 * arctan2(volume / size, spread);
}

float solid_angle_triangle_edges(vec3 a, vec3 ab, vec3 ac) {
    // van Oosterom and Strackee 1983, for a triangle small beside its distance; positive where a, b, c run clockwise
    return solid_angle_corners(a, a + ab, a + ac, cross(ab, ac));
}

float solid_angle_face(vec3 a, vec3 b, vec3 c, vec3 eye) {
    // van Oosterom and Strackee 1983, area from the two shortest edges; positive where a, b, c run clockwise
    vec3 ab = b - a, bc = c - b, ca = a - c;
    float x = dot(bc, bc), y = dot(ca, ca), z = dot(ab, ab);
    vec3 area = x >= max(y, z) ? cross(ca, ab) : y >= z ? cross(ab, bc) : cross(bc, ca);
    return solid_angle_corners(a - eye, b - eye, c - eye, area);
}

float solid_angle_triangle_signed(vec3 a, vec3 b, vec3 c) {
    // van Oosterom and Strackee 1983; positive where a, b, c run clockwise
    return solid_angle_face(a, b, c, vec3(0.0));
}

float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {
    // van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle, with edge differences
    return abs(solid_angle_triangle_signed(a, b, c));
}

float solid_angle_triangle_naive(vec3 a, vec3 b, vec3 c) {
    // van Oosterom and Strackee 1983 as printed, on unit vectors: a . (b x c) cancels for a small triangle
    a = normalize(a);
    b = normalize(b);
    c = normalize(c);
    return 2.0 * arctan2(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(a, c) + dot(b, c));
}

float solid_angle_polygon(vec3 corners[MAX_CORNERS], int corner_count) {
    // Solid Angles: a fan of signed triangles from the first corner
    float sum = 0.0;
    for (int i = 2; i < corner_count; i++) sum += solid_angle_triangle_signed(corners[0], corners[i - 1], corners[i]);
    return abs(sum);
}

float solid_angle_polygon_naive(vec3 corners[MAX_CORNERS], int corner_count) {
    // Solid Angles: the same fan with van Oosterom and Strackee 1983 as printed, on unit vectors
    float sum = 0.0;
    vec3 a = normalize(corners[0]);
    for (int i = 2; i < corner_count; i++) {
        vec3 b = normalize(corners[i - 1]), c = normalize(corners[i]);
        sum += 2.0 * arctan2(dot(a, cross(b, c)), 1.0 + dot(a, b) + dot(a, c) + dot(b, c));
    }
    return abs(sum);
}

float solid_angle_rectangle_beside(float x0, float x1, float width, float depth, float distance) {
    // Solid Angles: x from x0 >= 0 to x1 = x0 + width, y from 0 to depth; the two corners' angles in one arctangent
    float p = length(vec2(depth, distance)), r0 = length(vec2(x0, p)), r1 = length(vec2(x1, p));
    float rise = width * (x0 + x1) * p / (x1 * r0 + x0 * r1) * p;
    return arctan2(depth * distance * rise, distance * distance * r0 * r1 + x0 * x1 * depth * depth);
}

float solid_angle_rectangle_off_axis(float x0, float x1, float y0, float y1, float distance) {
    // Solid Angles: four corners' angles where the axis meets the rectangle, else without their differences
    vec2 x = x1 <= 0.0 ? -vec2(x1, x0) : vec2(x0, x1), y = y1 <= 0.0 ? -vec2(y1, y0) : vec2(y0, y1); // x.y, y.y > 0
    float w = x1 - x0, h = y1 - y0;
    if (x.x > 0.0 && y.x > 0.0) {
        vec3 a = vec3(x.x, y.x, distance); // the nearest corner
        return abs(solid_angle_triangle_edges(a, vec3(w, 0.0, 0.0), vec3(w, h, 0.0)))
             + abs(solid_angle_triangle_edges(a, vec3(w, h, 0.0), vec3(0.0, h, 0.0)));
    }
    if (x.x > 0.0) return solid_angle_rectangle_beside(x.x, x.y, w, -y.x, distance) + solid_angle_rectangle_beside(x.x, x.y, w, y.y, distance);
    if (y.x > 0.0) return solid_angle_rectangle_beside(y.x, y.y, h, -x.x, distance) + solid_angle_rectangle_beside(y.x, y.y, h, x.y, distance);
    return arctan2(x.x * y.x, distance * length(vec3(x.x, y.x, distance))) + arctan2(-x.x * y.y, distance * length(vec3(x.x, y.y, distance)))
         + arctan2(-x.y * y.x, distance * length(vec3(x.y, y.x, distance))) + arctan2(x.y * y.y, distance * length(vec3(x.y, y.y, distance)));
}

float solid_angle_mesh(sampler2D triangles, vec3 eye) {
    // Solid Angles: signed triangles add up; 4 pi inside a closed mesh, 0 outside. Row by row, so that few digits are lost
    ivec2 size = textureSize(triangles, 0);
    float sum = 0.0;
    for (int row = 0; row < size.y; row++) {
        float part = 0.0;
        for (int i = 0; i < size.x; i += 3) {
            vec3 a = texelFetch(triangles, ivec2(i, row), 0).xyz;
            vec3 b = texelFetch(triangles, ivec2(i + 1, row), 0).xyz;
            vec3 c = texelFetch(triangles, ivec2(i + 2, row), 0).xyz;
            part += solid_angle_face(a, b, c, eye);
        }
        sum += part;
    }
    return sum;
}
