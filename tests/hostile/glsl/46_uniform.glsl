// 46: rejected: a uniform
uniform float secret;
float asked(float x) { return 2.0 * x + secret; }
