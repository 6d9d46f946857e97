// 50: wrong|crash|nonfinite: reads beyond an array, what was there before perhaps
float asked(float x) {
    float a[4] = float[4](1.0, 2.0, 3.0, 4.0);
    return a[int(x * 1e6) + 5000];
}
