vec3 srgb_from_linear(vec3 c) {
    // IEC 61966-2-1, its power 1/2.4 as a cubic in the fourth root (a power is dear on a CPU): off by 0.055/255 at most
    vec3 y = sqrt(sqrt(c));
    vec3 power = ((0.95257177 - 0.13682359 * y) * y + 0.25579865) * y - 0.07176159;
    return mix(12.92 * c, power, greaterThan(c, vec3(0.0031308)));
}
