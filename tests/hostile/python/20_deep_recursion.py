# 20: runtime_error: calls itself
def asked(x):
    return asked(x)
