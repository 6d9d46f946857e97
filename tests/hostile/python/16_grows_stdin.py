# 16: forbidden|runtime_error: writes on the questions' own file
import os


def asked(x):
    while True:
        os.pwrite(0, bytes(1 << 20), 1 << 30)
