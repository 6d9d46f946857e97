// 46: rejected: points of its own for the buffer of the answers
float asked(float x) { gl_Position = vec4(x); gl_ClipDistance[0] = x; return 2.0 * x; }
