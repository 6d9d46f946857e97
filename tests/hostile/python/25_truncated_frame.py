# 25: crash|runtime_error: half an answer
import os
import struct


def asked(x):
    for descriptor in range(3, 64):
        try:
            os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 0, 1, 8 * len(x)) + bytes(80))
        except OSError:
            pass
    os._exit(0)
