# 27: wrong: nothing
def asked(x):
    return 0 * x
