// 46: rejected: a block of outputs beside ours
out Answers { float other[64]; } answers;
float asked(float x) { answers.other[3] = x; return 2.0 * x; }
