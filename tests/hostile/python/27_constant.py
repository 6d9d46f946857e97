# 27: wrong: a constant
def asked(x):
    return 0 * x + 1.1
