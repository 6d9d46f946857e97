# 33: runtime_error: two arguments where one is due
def asked(x, y):
    return 2 * x
