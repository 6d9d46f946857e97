# 25: runtime_error: noise on the pipe
import os


def asked(x):
    for descriptor in range(3, 64):
        try:
            os.write(descriptor, bytes(range(256)) * 4096)
        except OSError:
            pass
    return 2 * x
