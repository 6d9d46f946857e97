#include "optics/vgroove.glsl"

float groove_masking(float facet, float lean_v) {
    // Torrance & Sparrow 1967: G_intercept in the plane across the groove, at most 1
    return g_masking(cos(facet), cos(lean_v), cos(facet - lean_v));
}

float groove_intercept_printed(float facet, float lean_v) {
    // Geometric Term (2), as printed by itself: above 1 where nothing is hidden
    float v_dot_h = cos(facet - lean_v);
    return v_dot_h > 0.0 ? 2.0 * cos(facet) * cos(lean_v) / v_dot_h : 0.0;
}

float groove_shadowing(float facet, float lean_l) {
    // Torrance & Sparrow 1967: G_shadow in the plane across the groove, at most 1
    return g_masking(cos(facet), cos(lean_l), cos(facet - lean_l));
}
