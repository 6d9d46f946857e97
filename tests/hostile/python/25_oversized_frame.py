# 25: runtime_error: an answer of an exabyte
import os
import struct


def asked(x):
    for descriptor in range(3, 64):
        try:
            os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 0, 1, 1 << 60))
        except OSError:
            pass
    return 2 * x
