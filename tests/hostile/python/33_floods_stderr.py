# 33: output_limit: writes on both streams without end, in any bytes
import os


def asked(x):
    while True:
        os.write(2, os.urandom(1 << 16))
        os.write(1, b"\x1b[2J" * 1000)
