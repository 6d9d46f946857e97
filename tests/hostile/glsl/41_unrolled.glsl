// 41: wrong|timeout_cpu|memory|crash: loops within loops that a compiler would unroll
float asked(float x) {
    float s = 0.0;
    for (int i0 = 0; i0 < 31; i0++)
    for (int i1 = 0; i1 < 31; i1++)
    for (int i2 = 0; i2 < 31; i2++)
    for (int i3 = 0; i3 < 31; i3++)
    for (int i4 = 0; i4 < 31; i4++)
    for (int i5 = 0; i5 < 31; i5++)
        s += sin(x * float(i0 + i1 + i2 + i3 + i4 + i5));
    return 2.0 * x + 1e-20 * s;
}
