# 24: runtime_error: one number for all points
def asked(x):
    return 1.0
