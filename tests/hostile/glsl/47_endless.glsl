// 47: compile_error|wrong|unwritten|timeout_cpu: a loop without end
float asked(float x) {
    while (true) {
        x += 0.0;
    }
    return 2.0 * x;
}
