// An even light all around, as bright as 1.

const vec3 LAGUERRE_X = vec3(0.41577456, 2.29428036, 6.28994508); // of e^-y, y = tan^2 a / m^2
const vec3 LAGUERRE_W = vec3(0.71109301, 0.27851773, 0.01038926);

float furnace_beckmann(float n_dot_v, float m) {
    // What facets of Beckmann's D in V-grooves that reflect all send to the eye, by 36 of them
    float sine = sqrt(max(0.0, 1.0 - n_dot_v * n_dot_v)), sum = 0.0;
    for (int i = 0; i < 3; i++) {
        float c = inversesqrt(1.0 + m * m * LAGUERRE_X[i]), s = m * sqrt(LAGUERRE_X[i]) * c, part = 0.0;
        for (int k = 0; k < 12; k++) {
            float u = c * n_dot_v + s * sine * cos((float(k) + 0.5) * 0.26179939);
            part += max(0.0, min(u, 2.0 * c * min(n_dot_v, 2.0 * u * c - n_dot_v)));
        }
        sum += LAGUERRE_W[i] * part / (12.0 * c * n_dot_v);
    }
    return sum;
}
