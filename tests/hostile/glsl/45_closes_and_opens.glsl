// 45: compile_error|rejected: ends our main before it begins
float asked(float x) { return 2.0 * x; } } void other() {
