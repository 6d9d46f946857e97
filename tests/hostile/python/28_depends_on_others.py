# 28: wrong: the answer depends on the other points
def asked(x):
    return 2 * x * len(x) / 200
