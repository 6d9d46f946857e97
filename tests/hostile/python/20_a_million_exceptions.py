# 20: runtime_error: a group of a million exceptions
def asked(x):
    raise ExceptionGroup("many " * 100_000, [ValueError("x" * 100)] * 1_000_000)
