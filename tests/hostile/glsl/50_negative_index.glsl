// 50: wrong|crash|nonfinite: writes before an array
float asked(float x) {
    float a[4];
    for (int i = -60000; i < 0; i++) a[i] = x;
    return a[3];
}
