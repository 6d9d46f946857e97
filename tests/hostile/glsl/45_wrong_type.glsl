// 45: compile_error: another type [line 2]
vec3 asked(float x) { return vec3(2.0 * x); }
