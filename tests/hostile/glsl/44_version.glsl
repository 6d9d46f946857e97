// 44: rejected: its own version
#version 460
float asked(float x) { return 2.0 * x; }
