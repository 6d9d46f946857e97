#include "core/constants.glsl"
#include "optics/colour.glsl"

float map_pattern(float map_s, float map_t) {
    // 1 on the gilded ornament, 0 on the lacquer
    float q = cos(6.0 * PI * map_s) + cos(6.0 * PI * map_t);
    return clamp(0.5 + 5.0 * (abs(abs(q) - 1.0) - 2.0 / 3.0), 0.0, 1.0);
}

float plate_roughness(float map_s, float map_t) {
    // Ours: the strokes of a cloth, and worn gold
    float strokes = sin(2.0 * PI * (3.0 * map_s + 2.0 * map_t) + 2.0 * sin(4.0 * PI * map_t)), p = map_pattern(map_s, map_t);
    return 0.30 + 0.12 * p + (0.13 + 0.07 * p) * strokes;
}

float stored_roughness(sampler2D roughness_map, float map_s, float map_t) {
    // What the roughness map stores: a user's texels, bilinear; or the plate's own
    if (texelFetch(roughness_map, ivec2(0), 0).a > 0.0) {
        ivec2 size = textureSize(roughness_map, 0);
        vec2 at = vec2(map_s, map_t) * vec2(size) - 0.5, part = at - floor(at);
        ivec2 low = (ivec2(floor(at)) + size) % size, high = (low + 1) % size;
        vec2 below = vec2(texelFetch(roughness_map, low, 0).r, texelFetch(roughness_map, ivec2(high.x, low.y), 0).r);
        vec2 above = vec2(texelFetch(roughness_map, ivec2(low.x, high.y), 0).r, texelFetch(roughness_map, high, 0).r);
        vec2 across = mix(below, above, part.y);
        return mix(across.x, across.y, part.x);
    }
    return plate_roughness(map_s, map_t);
}

float roughness_as_srgb(sampler2D roughness_map, float map_s, float map_t) {
    // IEC 61966-2-1, where it does not belong
    return srgb_to_linear(stored_roughness(roughness_map, map_s, map_t));
}

float srgb_gap(float encoded) {
    // A stored number over what decoding makes of it
    return encoded <= 0.04045 ? 12.92 : encoded / srgb_to_linear(encoded);
}

float peak_gain(float encoded) {
    // D(0) = 1 / (pi m^2): a highlight whose roughness has been decoded as a colour
    float gap = srgb_gap(encoded);
    return gap * gap;
}

float peak_gain_at(sampler2D roughness_map, float map_s, float map_t) {
    // The same at a place of the plate
    return peak_gain(stored_roughness(roughness_map, map_s, map_t));
}
