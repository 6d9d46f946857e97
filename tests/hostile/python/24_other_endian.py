# 24: pass: the bytes the other way round
def asked(x):
    return (2 * x).astype(">f8")
