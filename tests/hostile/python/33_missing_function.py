# 33: missing: another name
def asks(x):
    return 2 * x
