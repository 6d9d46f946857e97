#include "optics/maps.glsl"
uniform sampler2D albedo_map, f0_map, roughness_map, normal_map;
uniform int own_albedo; // 1: a user's map is there
uniform int own_f0;
uniform int own_roughness;
uniform int own_normal;
// A lacquered plate with a gilded ornament in relief, as four maps; a user's own takes the place of each.

float relief(vec2 s) { return 0.012 * smoothstep(0.0, 1.0, map_pattern(s.x, s.y)); }

// What the four files store at a place: albedo, F0, roughness and normal, each from 0 to 1
vec3 stored(int map, vec2 s) {
    if (map == 0 && own_albedo == 1) return texture(albedo_map, s).rgb;
    if (map == 1 && own_f0 == 1) return texture(f0_map, s).rgb;
    if (map == 2 && own_roughness == 1) return texture(roughness_map, s).rgb;
    if (map == 3 && own_normal == 1) return texture(normal_map, s).rgb;
    if (map == 2) return vec3(plate_roughness(s.x, s.y));
    float gilt = map_pattern(s.x, s.y);
    if (map == 0) return mix(vec3(0.55, 0.10, 0.13), vec3(0.0), gilt);
    if (map == 1) return mix(vec3(0.2216), vec3(1.0, 0.86, 0.57), gilt);
    vec2 d = vec2(relief(s + vec2(0.004, 0.0)), relief(s + vec2(0.0, 0.004))) - relief(s);
    return 0.5 + 0.5 * normalize(vec3(-d / 0.008, 1.0)); // the plate is 2.04 wide, about
}

vec3 decoded(vec3 c) {
    // IEC 61966-2-1, its power 2.4 as a polynomial in a root (a power is dear on a CPU): off by 0.004/255 at most
    vec3 x = (c + 0.055) / 1.055, y = sqrt(x);
    vec3 power = x * x * (((0.06573326 * y - 0.26547053) * y + 1.13481118) * y + 0.06493894);
    return mix(c / 12.92, power, greaterThan(c, vec3(0.04045)));
}
