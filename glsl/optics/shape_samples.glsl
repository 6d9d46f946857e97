#include "optics/light_shape.glsl"
#include "optics/light_samples.glsl"
#include "optics/spherical_rectangle.glsl"

float even_in_angle(float panel_width, float panel_depth, vec3 seen) {
    // Pharr 2023, pbrt-v4: 1 where samples even in solid angle are worth it, 0 for a panel far or thin, and behind it
    return seen.z > 0.0 && min(panel_width, panel_depth) > 0.03 * length(seen) ? 1.0 : 0.0;
}

vec2 fan_point(float s, float t) {
    // Turk 1990, Generating Random Points in Triangles: even over the pentagon about 0, a fan from its first corner
    float x = 0.68 * t; // along the fan; its triangles have areas 0.19, 0.30 and 0.19
    float side = x < 0.19 ? x / 0.19 : x < 0.49 ? 1.0 : (0.68 - x) / 0.19;
    float across = x < 0.19 ? 0.5 - 0.2 * side : x < 0.49 ? 0.3 - 2.0 * (x - 0.19) : 0.2 * side - 0.5;
    return sqrt(s) * vec2(across, 0.4 + 0.6 * side) - vec2(0.0, 0.5);
}

vec2 shape_point(int light_shape, float s, float t) {
    // Area Lights: even in area over a flat shape in the unit square about 0
    return light_shape == 1 ? 0.5 * concentric_disk(s, t) : light_shape == 3 ? fan_point(s, t) : vec2(s, t) - 0.5;
}

float shape_holds(int light_shape, float s, float t) {
    // Gamito 2016, Solid Angle Sampling of Disk and Cylinder Lights: 1 where a sample of the whole square hits the shape
    float x = abs(s - 0.5), y = t - 0.5;
    if (light_shape == 1) return x * x + y * y <= 0.25 ? 1.0 : 0.0;
    if (light_shape == 3) return t >= 0.8 * x && 3.0 * x + t <= 1.9 ? 1.0 : 0.0;
    return 1.0;
}

float sampled_area(int light_shape, float light_x, float light_y, float light_height, float panel_width, float panel_depth, vec3 position) {
    // Light Contribution of Area Lights (1): the area the samples share: all of it, of a sphere the cap the point sees
    float radius = 0.5 * panel_width, d = length(vec3(light_x, light_y, light_height) - position);
    if (light_shape == 2 && d > radius) return 2.0 * PI * radius * radius * (d - radius) / d;
    return light_area(light_shape, panel_width, panel_depth);
}

float sample_flux(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, vec3 position, int level) {
    // Light Contribution of Area Lights (1): the flux of each of the punctual lights the light is cut into, pi L A / N
    return PI * radiance * sampled_area(light_shape, light_x, light_y, light_height, panel_width, panel_depth, position) / float(1 << (2 * level));
}

float sample_share(vec3 to_sample) {
    // Light Contribution of Area Lights (1): n.l / r^3, what a sample gives per area, radiance and distance to its plane
    float r2 = dot(to_sample, to_sample);
    return to_sample.z > 0.0 ? to_sample.z / (r2 * r2) : 0.0;
}

vec4 sphere_piece(vec3 to_light, float radius, int sampling, float s, float t) {
    // Shirley, Wang, Zimmerman 1996, Monte Carlo Techniques for Direct Lighting Calculations: the cap a point sees, even in
    // area, or its cone, even in solid angle; from inside all directions. (way to the sample, its weight)
    float d = length(to_light), lean = length(to_light.xy);
    vec3 w = d > 0.0 ? to_light / d : vec3(0.0, 0.0, 1.0);
    vec3 aside = lean > 0.0 ? vec3(-w.z * (to_light.xy / lean), lean / d) : vec3(1.0, 0.0, 0.0), across = cross(w, aside);
    if (sampling < 4 && d > radius) {
        vec2 p = concentric_disk(s, t);
        float h = d - radius, r2 = dot(p, p), low = h / d * r2, away = h * h + 2.0 * radius * h * r2; // low = 1 - cos
        p *= radius * sqrt(h / d * (2.0 - low));
        float rim = min(min(s, 1.0 - s), min(t, 1.0 - t)); // 1 - r2 = 4 rim (1 - rim)
        float weight = 8.0 * PI * (radius / away) * (radius / sqrt(away)) * (h / d) * (h * rim * (1.0 - rim));
        return vec4(w * (h + radius * low) + aside * p.x + across * p.y, weight);
    }
    float q = d > radius ? radius / d : 1.0, wide = d > radius ? q * q / (1.0 + sqrt((1.0 - q) * (1.0 + q))) : 2.0;
    float low = wide * s, c = 1.0 - low, e = sqrt(low * (2.0 - low)), turn = 2.0 * PI * t;
    float half_chord = sqrt(max((radius - d * e) * (radius + d * e), 0.0));
    vec3 to = w * c + e * (aside * cos(turn) + across * sin(turn));
    return vec4((d > radius ? d * c - half_chord : d * c + half_chord) * to, 2.0 * PI * wide);
}

vec4 light_piece(int light_shape, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int sampling, int level, int seed, int index) {
    // Light Contribution of Area Lights (1): the way to a sample, and its weight: the mean of weights is the solid angle
    vec3 at = light_sample(sampling, level, seed, index), way = vec3(light_x, light_y, light_height) - position;
    if (light_shape == 2) return sphere_piece(way, 0.5 * panel_width, sampling, at.x, at.y) * vec4(1.0, 1.0, 1.0, at.z);
    float depth = light_shape == 1 ? panel_width : panel_depth, tilt = light_shape == 1 ? 0.0 : panel_tilt, c = cos(tilt), s = sin(tilt);
    vec3 seen = panel_view(light_x, light_y, light_height, tilt, position);
    if (sampling < 4 || even_in_angle(panel_width, depth, seen) < 0.5) {
        vec2 p = shape_point(light_shape, at.x, at.y);
        way += vec3(p.x * panel_width, p.y * depth * c, p.y * depth * s);
        float r = length(way), area = light_area(light_shape, panel_width, panel_depth);
        return vec4(way, at.z * area * max(seen.z, 0.0) / r / (r * r));
    }
    vec2 x = seen.x + vec2(-0.5, 0.5) * panel_width, y = seen.y + vec2(-0.5, 0.5) * depth;
    vec3 p = spherical_rectangle_point(x.x, x.y, y.x, y.y, seen.z, at.x, at.y);
    float hit = shape_holds(light_shape, (p.x - x.x) / panel_width, (p.y - y.x) / depth);
    return vec4(p.x, p.y * c - p.z * s, p.y * s + p.z * c, at.z * hit * solid_angle_rectangle_off_axis(x.x, x.y, y.x, y.y, seen.z));
}

float irradiance_light_sampled(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int sampling, int level, int seed) {
    // Light Contribution of Area Lights (1): L times the mean of light_piece's weight times n.l, what is alike for all
    // samples of a point taken out of the loops. A loop for each way: one without rounds costs a processor nothing
    float depth = light_shape == 1 ? panel_width : panel_depth, tilt = light_shape == 1 ? 0.0 : panel_tilt, c = cos(tilt), s = sin(tilt);
    vec3 way = vec3(light_x, light_y, light_height) - position, seen = panel_view(light_x, light_y, light_height, tilt, position);
    vec3 side = vec3(panel_width, 0.0, 0.0), up = depth * vec3(0.0, c, s);
    int rows = 1 << level, count = rows * rows, kind = sampling == 4 ? 3 : sampling;
    bool by_angle = sampling > 3 && even_in_angle(panel_width, depth, seen) > 0.5;
    int by_area = light_shape == 2 || seen.z <= 0.0 || by_angle ? 0 : count;
    float sum = 0.0, scale = light_area(light_shape, panel_width, panel_depth) * seen.z;
    for (int i = 0; i < (light_shape == 0 && sampling != 5 ? by_area : 0); i++) {
        vec2 p = spread_sample(kind, level, seed, i) - 0.5;
        sum += sample_share(way + p.x * side + p.y * up);
    }
    for (int i = 0; i < (light_shape == 1 && sampling != 5 ? by_area : 0); i++) {
        vec2 at = spread_sample(kind, level, seed, i), p = 0.5 * concentric_disk(at.x, at.y);
        sum += sample_share(way + p.x * side + p.y * up);
    }
    for (int i = 0; i < (light_shape == 3 && sampling != 5 ? by_area : 0); i++) {
        vec2 at = spread_sample(kind, level, seed, i), p = fan_point(at.x, at.y);
        sum += sample_share(way + p.x * side + p.y * up);
    }
    for (int i = 0; i < (sampling == 5 ? by_area : 0); i++) {
        vec3 at = gauss_sample(i, level);
        vec2 p = shape_point(light_shape, at.x, at.y);
        sum += float(count) * at.z * sample_share(way + p.x * side + p.y * up);
    }
    if (light_shape == 2) { // sphere_piece, with the axis towards its middle and the sine of that axis' angle from n
        float radius = 0.5 * panel_width, d = length(way), lean = d > 0.0 ? length(way.xy) / d : 0.0, up_to = d > 0.0 ? way.z / d : 1.0;
        bool is_cap = sampling < 4 && d > radius;
        float h = d - radius, low_cap = h / d, q = d > radius ? radius / d : 1.0;
        float wide = d > radius ? q * q / (1.0 + sqrt((1.0 - q) * (1.0 + q))) : 2.0;
        for (int i = 0; i < (is_cap ? count : 0); i++) {
            vec2 at = spread_sample(kind, level, seed, i), e = 2.0 * at - 1.0;
            float r2 = max(e.x * e.x, e.y * e.y), low = low_cap * r2, away = h * (h + 2.0 * radius * r2);
            float z = up_to * (h + radius * low) + lean * radius * concentric_disk(at.x, at.y).x * sqrt(low_cap * (2.0 - low));
            sum += (1.0 - r2) * max(z, 0.0) / (away * away);
        }
        for (int i = 0; i < (is_cap || sampling == 5 ? 0 : count); i++) {
            vec2 at = spread_sample(kind, level, seed, i);
            float low = wide * at.x;
            sum += max(up_to * (1.0 - low) + lean * sqrt(low * (2.0 - low)) * cos(2.0 * PI * at.y), 0.0);
        }
        for (int i = 0; i < (sampling == 5 ? count : 0); i++) {
            vec3 at = gauss_sample(i, level);
            float low = wide * at.x;
            sum += float(count) * at.z * max(up_to * (1.0 - low) + lean * sqrt(low * (2.0 - low)) * cos(2.0 * PI * at.y), 0.0);
        }
        scale = 2.0 * PI * (is_cap ? radius * radius * low_cap * h : wide);
    }
    for (int once = light_shape != 2 && by_angle ? 0 : 1; once < 1; once++) {
        // Urena 2013: strip_end and strip_across with w = x / length(x, z), q = z / length(x, z), v the sine of latitude
        vec2 x = seen.x + vec2(-0.5, 0.5) * panel_width, y = seen.y + vec2(-0.5, 0.5) * depth, y2 = y * y;
        float z = seen.z, z2 = z * z, r0 = length(vec2(y.x, z)), r1 = length(vec2(y.y, z)), k0 = y.x / r0, k1 = y.y / r1;
        float less = (z / r0) * (z / r0) * (y.y - y.x) * ((y.y + y.x) / (r1 * r1)) / (abs(k1) + abs(k0));
        float less2 = less * less, both = 4.0 * abs(k0 * k1);
        float strip0 = 0.5 * strip_angle(x.x, y.x, y.y, z), strip1 = 0.5 * strip_angle(x.y, y.x, y.y, z);
        vec2 across = vec2(1.0 / panel_width, 1.0 / depth);
        bool is_same = k0 * k1 > 0.0;
        for (int i = 0; i < (sampling == 4 ? count : 0); i++) {
            vec2 at = sobol_sample(i, seed);
            float turn = mix(strip0, strip1, at.x), sine = sine_of(turn), cosine = sqrt((1.0 - sine) * (1.0 + sine));
            float h = is_same ? sine : cosine, w = 2.0 * sine * cosine * inversesqrt(less2 + both * h * h);
            float q2 = max((1.0 - w) * (1.0 + w), 1e-30), q = sqrt(q2);
            vec2 ends = q * y * inversesqrt(q2 * y2 + z2);
            float v = mix(ends.x, ends.y, at.y), u = sqrt(max((1.0 - v) * (1.0 + v), 1e-30)), far = z / (q * u);
            float share = max(v * s + q * u * c, 0.0);
            sum += share * shape_holds(light_shape, (w * u * far - x.x) * across.x, (v * far - y.x) * across.y);
        }
        for (int i = 0; i < (sampling == 5 ? rows : 0); i++) {
            vec2 a = gauss_node(i, level);
            float turn = mix(strip0, strip1, a.x), sine = sine_of(turn), cosine = sqrt((1.0 - sine) * (1.0 + sine)), part = 0.0;
            float h = is_same ? sine : cosine, w = 2.0 * sine * cosine * inversesqrt(less2 + both * h * h);
            float q2 = max((1.0 - w) * (1.0 + w), 1e-30), q = sqrt(q2);
            vec2 ends = q * y * inversesqrt(q2 * y2 + z2);
            for (int j = 0; j < rows; j++) {
                vec2 b = gauss_node(j, level);
                float v = mix(ends.x, ends.y, b.x), u = sqrt(max((1.0 - v) * (1.0 + v), 1e-30)), far = z / (q * u);
                float share = max(v * s + q * u * c, 0.0);
                part += b.y * share * shape_holds(light_shape, (w * u * far - x.x) * across.x, (v * far - y.x) * across.y);
            }
            sum += float(count) * a.y * part;
        }
        scale = solid_angle_rectangle_off_axis(x.x, x.y, y.x, y.y, z);
    }
    return radiance * scale * sum / float(count);
}

float irradiance_light_without_cosine(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int level) {
    // Light Contribution of Area Lights (1), misread: fixed samples that shine alike in every direction, without cos_light
    float sum = 0.0, area = sampled_area(light_shape, light_x, light_y, light_height, panel_width, panel_depth, position);
    bool inside = light_shape == 2 && length(vec3(light_x, light_y, light_height) - position) <= 0.5 * panel_width;
    for (int row = 0; row < 1 << level; row++) { // a sum of sums: one of a thousand terms would lose a digit
        float part = 0.0;
        for (int i = 0; i < 1 << level; i++) {
            vec4 piece = light_piece(light_shape, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position, 0, level, 0, (row << level) + i);
            float r2 = dot(piece.xyz, piece.xyz), weight = inside ? piece.w : piece.w > 0.0 ? area / r2 : 0.0;
            part += weight * max(piece.z, 0.0) / sqrt(r2);
        }
        sum += part;
    }
    return radiance * sum / float(1 << (2 * level));
}
