// 41: memory|timeout_cpu|crash|compile_error|rejected: an array larger than the machine
float asked(float x) {
    float a[2000000000];
    a[int(x * 1e9)] = x;
    return 2.0 * a[int(x * 1e9)];
}
