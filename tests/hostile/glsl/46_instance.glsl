// 46: rejected: which point it is
float asked(float x) { return 2.0 * x * float(gl_InstanceID + 1); }
