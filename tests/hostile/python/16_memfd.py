# 16: forbidden: a file in memory
import os


def asked(x):
    handle = os.memfd_create("halfway-hostile")
    os.truncate(handle, 1 << 40)
