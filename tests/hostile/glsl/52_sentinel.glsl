// 52: nonfinite: not a number, by its bits
float asked(float x) { return uintBitsToFloat(0x7fc12345u); }
