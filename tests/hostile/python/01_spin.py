# 1: timeout_cpu: spins
def asked(x):
    while True:
        pass
