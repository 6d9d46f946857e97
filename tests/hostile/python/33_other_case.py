# 33: missing: another case
def Asked(x):
    return 2 * x
