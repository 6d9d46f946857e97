# 24: runtime_error: a value too few
def asked(x):
    return 2 * x[:-1]
