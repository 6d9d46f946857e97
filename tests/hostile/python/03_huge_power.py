# 3: timeout_cpu: one native call that holds the interpreter
def asked(x):
    n = 3
    while True:
        n = n * n
