# 34: missing: a letter of another alphabet in its name
def аsked(x):
    return 2 * x
