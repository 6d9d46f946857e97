#include "core/constants.glsl"

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
    uint x = 0u, y = 0u, flip = uint(seed) * 2654435769u, v = 1u << 31u;
    int i = index;
    for (uint bit = 1u << 31u; i != 0; bit >>= 1u) {
        if ((i & 1) == 1) {
            x ^= bit;
            y ^= v;
        }
        v ^= v >> 1u;
        i >>= 1;
    }
    x ^= flip;
    y ^= flip * 747796405u;
    return vec2(float(x >> 8u), float(y >> 8u)) / 16777216.0;
}

vec3 gauss_sample(int index, int level) {
    // Abramowitz and Stegun 25.4.30: (s, t, weight); from 8 x 8 points on, cells with 8 x 8 each
    int rows = 1 << level, part = min(level, 3), order = 1 << part, i = index & (rows - 1), j = index >> level;
    vec2 cell = vec2(float(i >> part), float(j >> part));
    i = order - 1 + (i & (order - 1));
    j = order - 1 + (j & (order - 1));
    float n = float(rows >> part);
    return vec3((cell + vec2(RULE_AT[i], RULE_AT[j])) / n, RULE_WEIGHT[i] * RULE_WEIGHT[j] / (n * n));
}
