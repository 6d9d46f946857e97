// 45: compile_error|rejected|missing: a constant where the function is due
const float asked = 2.0;
