float toksvig_exponent(float normal_length, float exponent) {
    // Toksvig 2005, Mipmapping Normal Maps: shorter mean normals make wider highlights
    float below = normal_length + exponent * (1.0 - normal_length);
    return below > 0.0 ? exponent * normal_length / below : 0.0;
}

float vmf_mean_length(float kappa) {
    // Langevin 1905: coth kappa - 1 / kappa, the mean of unit vectors spread as exp(kappa cos); a series below 1
    if (kappa < 1.0) {
        float q = kappa * kappa;
        return kappa * (1.0 / 3.0 - q * (1.0 / 45.0 - q * (2.0 / 945.0 - q * (1.0 / 4725.0 - q * (2.0 / 93555.0 - q * (1382.0 / 638512875.0 - q * (4.0 / 18243225.0)))))));
    }
    float e = exp(-2.0 * min(kappa, 40.0));
    return (1.0 + e) / (1.0 - e) - 1.0 / kappa;
}
