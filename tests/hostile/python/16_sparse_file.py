# 16: forbidden: a file full of holes
import os


def asked(x):
    handle = os.open("/tmp/halfway-hostile-sparse", os.O_CREAT | os.O_WRONLY)
    os.ftruncate(handle, 1 << 40)
