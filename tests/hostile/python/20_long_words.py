# 20: runtime_error: 100 MB of words
def asked(x):
    raise ValueError("x" * 100_000_000)
