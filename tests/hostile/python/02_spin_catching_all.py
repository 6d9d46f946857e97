# 2: timeout_cpu: spins, and catches whatever would stop it
def asked(x):
    while True:
        try:
            while True:
                pass
        except BaseException:
            pass
