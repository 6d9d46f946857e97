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
