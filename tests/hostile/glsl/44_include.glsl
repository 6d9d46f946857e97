// 44: rejected: a file of the course
#include "optics/fresnel.glsl"
float asked(float x) { return 2.0 * x; }
