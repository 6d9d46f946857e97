#include "optics/lambert.glsl"
#include "optics/oren_nayar.glsl"
#include "optics/eon.glsl"

// The eye looks along -z; the light comes from `phase` to its right.

vec3 disk_normal(float disk_x) {
    // A sphere: its middle faces the eye
    return vec3(disk_x, 0.0, sqrt(max(0.0, (1.0 - disk_x) * (1.0 + disk_x))));
}

float disk_lambert(float disk_x, float phase, float rho) {
    // Lambert 1760, Photometria: pi f n.l
    vec3 n = disk_normal(disk_x), l = direction(phase, 0.0);
    return PI * brdf_lambert(n, l, vec3(0.0, 0.0, 1.0), rho) * max(0.0, dot(n, l));
}

float disk_oren_nayar(float disk_x, float phase, float rho, float sigma) {
    // Oren and Nayar 1994: pi f n.l
    vec3 n = disk_normal(disk_x), l = direction(phase, 0.0);
    return PI * brdf_oren_nayar(n, l, vec3(0.0, 0.0, 1.0), rho, sigma) * max(0.0, dot(n, l));
}

float disk_eon(float disk_x, float phase, float rho, float roughness) {
    // Portsmouth, Kutz and Hill 2025: pi f n.l
    vec3 n = disk_normal(disk_x), l = direction(phase, 0.0);
    return PI * brdf_eon(n, l, vec3(0.0, 0.0, 1.0), rho, roughness) * max(0.0, dot(n, l));
}

float rim_oren_nayar(float disk_x, float phase, float sigma) {
    // Oren and Nayar 1994: over the middle of the disk
    return disk_oren_nayar(disk_x, phase, 1.0, sigma) / disk_oren_nayar(0.0, phase, 1.0, sigma);
}
