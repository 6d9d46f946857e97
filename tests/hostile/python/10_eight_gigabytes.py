# 10: memory: asks for 8 GB
def asked(x):
    return bytearray(8 << 30)
