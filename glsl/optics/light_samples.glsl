#include "core/angle.glsl"

// Gauss-Legendre on [0, 1] with 1, 2, 4 and 8 points: where they are, and their weights
const float RULE_AT[15] = float[15](0.5, 0.2113248654, 0.7886751346, 0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558, 0.0198550718, 0.1016667613, 0.2372337950, 0.4082826788, 0.5917173212, 0.7627662050, 0.8983332387, 0.9801449282);
const float RULE_WEIGHT[15] = float[15](1.0, 0.5, 0.5, 0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226, 0.0506142681, 0.1111905172, 0.1568533229, 0.1813418917, 0.1813418917, 0.1568533229, 0.1111905172, 0.0506142681);

float random_number(int index, int seed) {
    // Jarzynski and Olano 2020, Hash Functions for GPU Rendering: pcg; the upper 24 bits, which float32 holds
    uint state = uint(index) * 747796405u + uint(seed) * 2654435769u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

vec2 grid_sample(int index, int level) {
    // Area Lights (1): the middles of rows x rows equal cells, rows = 2^level
    int rows = 1 << level;
    return (vec2(float(index & (rows - 1)), float(index >> level)) + 0.5) / float(rows);
}

vec2 random_sample(int index, int seed) {
    // Area Lights (1): anywhere, each for itself
    return vec2(random_number(2 * index, seed), random_number(2 * index + 1, seed));
}

vec2 stratified_sample(int index, int level, int seed) {
    // Area Lights (1): anywhere within its own of rows x rows cells
    int rows = 1 << level;
    return (vec2(float(index & (rows - 1)), float(index >> level)) + random_sample(index, seed)) / float(rows);
}

vec2 sobol_sample(int index, int seed) {
    // Kollig and Keller 2002, Efficient Multidimensional Sampling: the (0,2)-sequence, its digits flipped by the seed
    uint x = uint(index), y = x, flip = uint(seed) * 2654435769u; // index < 65536
    y ^= (y >> 1u) & 0x5555u; // Pascal's triangle of odd numbers, halved four times
    y ^= (y >> 2u) & 0x3333u;
    y ^= (y >> 4u) & 0x0f0fu;
    y ^= (y >> 8u) & 0x00ffu;
    x |= y << 16u; // the bits of both halves turned round at once
    x = ((x & 0x55555555u) << 1u) | ((x >> 1u) & 0x55555555u);
    x = ((x & 0x33333333u) << 2u) | ((x >> 2u) & 0x33333333u);
    x = ((x & 0x0f0f0f0fu) << 4u) | ((x >> 4u) & 0x0f0f0f0fu);
    x = ((x & 0x00ff00ffu) << 8u) | ((x >> 8u) & 0x00ff00ffu);
    y = (x & 0xffff0000u) ^ (flip * 747796405u);
    x = (x << 16u) ^ flip;
    return vec2(float(x >> 8u), float(y >> 8u)) / 16777216.0;
}

vec2 gauss_node(int index, int level) {
    // Abramowitz and Stegun 25.4.30: where on [0, 1], and the weight; from 8 points on, cells with 8 each
    int part = min(level, 3), order = 1 << part, i = order - 1 + (index & (order - 1));
    return vec2(float(index >> part) + RULE_AT[i], RULE_WEIGHT[i]) / float(1 << (level - part));
}

vec3 gauss_sample(int index, int level) {
    // Abramowitz and Stegun 25.4.30: the product rule on the unit square, (s, t, weight)
    vec2 a = gauss_node(index & ((1 << level) - 1), level), b = gauss_node(index >> level, level);
    return vec3(a.x, b.x, a.y * b.y);
}

vec2 spread_sample(int sampling, int level, int seed, int index) {
    // Light Contribution of Area Lights (1): 0 fixed, 1 random, 2 stratified, 3 and more Sobol
    vec2 at = sampling == 0 ? vec2(0.5) : random_sample(index, seed);
    int rows = sampling == 1 ? 1 : 1 << level;
    vec2 cell = sampling == 1 ? vec2(0.0) : vec2(float(index & (rows - 1)), float(index >> level));
    return sampling > 2 ? sobol_sample(index, seed) : (cell + at) / float(rows);
}

vec3 light_sample(int sampling, int level, int seed, int index) {
    // Light Contribution of Area Lights (1): (s, t, weight) of a sample; weights sum to the number of samples.
    // 0 fixed, 1 random, 2 stratified, 3 and 4 Sobol, 5 Gauss-Legendre
    if (sampling == 5) return gauss_sample(index, level) * vec3(1.0, 1.0, float(1 << (2 * level)));
    return vec3(spread_sample(sampling, level, seed, index), 1.0);
}

vec2 concentric_disk(float s, float t) {
    // Shirley and Chiu 1997, A Low Distortion Map Between Disk and Square: rings of squares become rings of the disk
    vec2 p = 2.0 * vec2(s, t) - 1.0;
    bool wide = abs(p.x) > abs(p.y);
    float r = wide ? p.x : p.y, a = r == 0.0 ? 0.0 : 0.25 * PI * (wide ? p.y : p.x) / r, y = sine_of(a), x = sqrt((1.0 - y) * (1.0 + y));
    return r * (wide ? vec2(x, y) : vec2(y, x));
}
