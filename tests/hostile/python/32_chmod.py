# 32: forbidden: takes rights away
import os


def asked(x):
    os.chmod("/tmp", 0)
    return 2 * x
