# 13: runtime_error: pipes, each filled, until there are no more
import fcntl
import os


def asked(x):
    while True:
        ends = os.pipe()
        fcntl.fcntl(ends[1], 1031, 1 << 20)
        os.set_blocking(ends[1], False)
        os.write(ends[1], bytes(1 << 20))
