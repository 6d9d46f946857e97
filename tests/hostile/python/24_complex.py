# 24: runtime_error: complex numbers
def asked(x):
    return 2 * x + 0j
