# 8: timeout_cpu: spins while it is read
while True:
    pass
