// An even light all around, as bright as 1.

const float FACET_SLOPES[6] = float[6](0.2949769, 0.53636, 0.7341638, 0.9356649, 1.17741, 1.576359); // over m, each as likely

float furnace_beckmann(float n_dot_v, float m) {
    // What facets of Beckmann's D in V-grooves that reflect all send to the eye, by 6 x 12 of them: within 0.02
    float sine = sqrt(max(0.0, 1.0 - n_dot_v * n_dot_v)), sum = 0.0;
    for (int i = 0; i < 6; i++) {
        float slope = m * FACET_SLOPES[i], c = inversesqrt(1.0 + slope * slope), part = 0.0;
        for (int k = 0; k < 12; k++) {
            float u = c * n_dot_v + slope * c * sine * cos((float(k) + 0.5) * 0.26179939);
            part += max(0.0, min(u, 2.0 * c * min(n_dot_v, 2.0 * u * c - n_dot_v)));
        }
        sum += part / (72.0 * c * n_dot_v);
    }
    return sum;
}
