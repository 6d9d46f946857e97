# 16: forbidden: a file of 1 GB
def asked(x):
    with open("/tmp/halfway-hostile-big", "wb") as out:
        for _ in range(1024):
            out.write(bytes(1 << 20))
