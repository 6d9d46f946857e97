// 49: rejected: no value at all
float asked(float x) {
    if (x < 0.5) discard;
    return 2.0 * x;
}
