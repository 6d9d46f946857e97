# 33: runtime_error: a generator
def asked(x):
    yield 2 * x
