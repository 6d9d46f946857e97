# 25: runtime_error: answers in the name of the worker before it is asked, and then again
import os
import struct

for descriptor in range(3, 64):
    try:
        os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 0xFFFFFFFF, 0, 0))
        os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 0, 1, 8 * 232) + bytes(8 * 232))
    except OSError:
        pass


def asked(x):
    return 2 * x
