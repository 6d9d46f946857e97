#include "optics/blinn_phong.glsl"
#include "optics/interface.glsl"
#include "optics/materials.glsl"

// complaint 0: guessed coefficients; 1: the mirror of plastic; 2: gold, blue; 3: an exponent doubled; 4: a furnace

float complaint_model(int complaint, float theta) {
    // Need for a Physically-based Reflectance Model: what Blinn-Phong gives
    if (complaint == 0) return 1.3;
    if (complaint == 1) return reflected_share(0.0, 1.5);
    if (complaint == 2) return material_share(0.0, 5, 2);
    if (complaint == 3) return half_width_phong(200.0) / half_width_phong(100.0);
    return albedo_blinn_phong_limit(theta);
}

float complaint_truth(int complaint, float theta) {
    // Fresnel 1823; of what enters plastic, 8 tenths come out
    if (complaint == 0) return 0.8 + 0.2 * reflected_share(theta, 1.5);
    if (complaint == 1) return reflected_share(theta, 1.5);
    if (complaint == 2) return material_share(theta, 5, 2);
    return complaint == 3 ? 0.5 : 1.0;
}
