// 46: rejected: a buffer
layout(std430) buffer Data { float data[]; };
float asked(float x) { return data[0]; }
