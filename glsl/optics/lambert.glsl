#include "core/constants.glsl"

float brdf_lambert(vec3 n, vec3 l, vec3 v, float rho) {
    // Lambert 1760, Photometria: the same radiance in every direction; the deck's rho / pi
    return dot(n, l) > 0.0 && dot(n, v) > 0.0 ? rho / PI : 0.0;
}
