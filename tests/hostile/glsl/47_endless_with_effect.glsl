// 47: wrong|unwritten|timeout_cpu: a loop without end that counts
float asked(float x) {
    float sum = 0.0;
    for (int i = 0; i >= 0; i = i < 1000 ? i + 1 : 0) {
        sum += x;
    }
    return sum;
}
