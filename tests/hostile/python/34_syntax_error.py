# 34: compile_error: does not parse
def asked(x):
    return 2 * x)
