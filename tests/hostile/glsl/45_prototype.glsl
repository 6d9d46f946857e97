// 45: missing: a promise without a body
float asked(float x);
