# 27: wrong: its argument
def asked(x):
    return x
