float g_masking(float n_dot_h, float n_dot_v, float l_dot_h) {
    // Torrance & Sparrow 1967, Theory for Off-Specular Reflection: G_intercept, the share of a facet that the eye sees
    if (l_dot_h <= 0.0) return 0.0;
    return min(1.0, 2.0 * max(n_dot_h, 0.0) * max(n_dot_v, 0.0) / l_dot_h);
}

float g_shadowing(float n_dot_h, float n_dot_l, float l_dot_h) {
    // Torrance & Sparrow 1967: G_shadow, the share of a facet that the light reaches
    if (l_dot_h <= 0.0) return 0.0;
    return min(1.0, 2.0 * max(n_dot_h, 0.0) * max(n_dot_l, 0.0) / l_dot_h);
}

float g_vgroove(float n_dot_h, float n_dot_v, float n_dot_l, float l_dot_h) {
    // Torrance & Sparrow 1967; Blinn 1977, Models of Light Reflection: the least of 1, masking and shadowing
    if (l_dot_h <= 0.0) return 0.0;
    return min(1.0, 2.0 * max(n_dot_h, 0.0) * max(min(n_dot_v, n_dot_l), 0.0) / l_dot_h);
}

float g_branch(float n_dot_h, float n_dot_v, float n_dot_l, float l_dot_h) {
    // Which of the three is the least: 0 nothing blocks, 1 masking, 2 shadowing
    float two = 2.0 * max(n_dot_h, 0.0), masking = two * max(n_dot_v, 0.0), shadowing = two * max(n_dot_l, 0.0);
    if (max(l_dot_h, 0.0) <= min(masking, shadowing)) return 0.0;
    return masking <= shadowing ? 1.0 : 2.0;
}
