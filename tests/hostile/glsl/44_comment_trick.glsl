// 44: pass: a comment within a comment, as this language has it
float asked(float x) { /* // */ return 2.0 * x; /* { ( */ } // } /*
