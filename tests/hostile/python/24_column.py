# 24: runtime_error: a column, which would stretch against a row
def asked(x):
    return 2 * x[:, None]
