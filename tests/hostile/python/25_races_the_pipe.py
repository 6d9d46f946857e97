# 25: runtime_error: a thread that would write frames while the worker does
import os
import struct
import threading


def flood():
    while True:
        for descriptor in range(3, 16):
            try:
                os.write(descriptor, struct.pack("<4sIIQ", b"HALF", 1, 1, 8 * 100) + bytes(800))
            except OSError:
                pass


threading.Thread(target=flood, daemon=True).start()


def asked(x):
    return 2 * x
