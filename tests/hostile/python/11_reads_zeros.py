# 11: forbidden|memory: reads /dev/zero to its end
def asked(x):
    return open("/dev/zero", "rb").read()
