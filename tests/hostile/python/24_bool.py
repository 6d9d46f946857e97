# 24: runtime_error: truth values
def asked(x):
    return x > 0
