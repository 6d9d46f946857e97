float linear_to_srgb(float linear) {
    // IEC 61966-2-1, encoding
    if (linear <= 0.0031308) return 12.92 * linear;
    return 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

float srgb_to_linear(float encoded) {
    // IEC 61966-2-1, decoding
    if (encoded <= 0.04045) return encoded / 12.92;
    return pow((encoded + 0.055) / 1.055, 2.4);
}
