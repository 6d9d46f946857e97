# 24: runtime_error: a table where a list is due
def asked(x):
    return x[:, None] + x[None, :]
