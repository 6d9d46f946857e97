# 25: runtime_error: answers nobody asked for
import os
import struct
import sys


def asked(x):
    for descriptor in range(3, 64):
        try:
            os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 7, 1, 8) + bytes(8))
        except OSError:
            pass
    return 2 * x
