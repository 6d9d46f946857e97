# 24: pass: the input itself, changed
def asked(x):
    x *= 2
    return x
