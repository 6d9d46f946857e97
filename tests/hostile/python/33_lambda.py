# 33: pass: a lambda
asked = lambda x: 2 * x
