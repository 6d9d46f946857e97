# 20: runtime_error: KeyboardInterrupt
def asked(x):
    raise KeyboardInterrupt
