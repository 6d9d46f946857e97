#include "core/constants.glsl"

float complete_elliptic(float k_c, float root_p, float a, float b) {
    // Bulirsch 1969, "Numerical calculation of elliptic integrals and elliptic functions III", cel(k_c, p, a, b), p > 0:
    // the integral of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + k_c^2 sin^2)) over 0 .. pi/2; root_p = sqrt(p).
    float e = abs(k_c), m = 1.0, p = root_p, q = abs(k_c);
    b /= p;
    for (int i = 0; i < 12; i++) {
        float f = a, g = e / p;
        a += b / p;
        b = 2.0 * (b + f * g);
        p += g;
        g = m;
        m += q;
        if (abs(g - q) <= 1e-4 * g) break;
        q = 2.0 * sqrt(e);
        e = q * m;
    }
    return 0.5 * PI * (b + a * m) / (m * (m + p));
}
