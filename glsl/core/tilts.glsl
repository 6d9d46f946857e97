#include "core/constants.glsl"
#include "core/gauss.glsl"

const int TILTS = 72;

vec2 tilt_node(int i, float bend, float end) {
    // Node and weight of an integral over x = tan a / m from 0 to the end, at most 6.5, in pieces cut at 1.5, 3 and the
    // bend; x = lo + (hi - lo) sin^2 psi in each, so that a root at its ends does no harm
    int piece = i / 12;
    float from = piece < 2 ? 0.0 : piece < 4 ? 1.5 : 3.0, to = piece < 2 ? 1.5 : piece < 4 ? 3.0 : 6.5;
    float cut = clamp(bend, from, to), lo = min(piece % 2 == 0 ? from : cut, end), hi = min(piece % 2 == 0 ? cut : to, end);
    float psi = 0.5 * PI * GAUSS_X[i % 12], s = sin(psi);
    return vec2(lo + (hi - lo) * s * s, GAUSS_W[i % 12] * PI * (hi - lo) * s * cos(psi));
}
