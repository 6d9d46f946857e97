# 19: forbidden: would let the kernel kill the supervisor when it reads the pipe (F_SETOWN, F_SETSIG, O_ASYNC)
import fcntl
import os
import signal


def asked(x):
    for descriptor in range(1, 64):
        try:
            os.fstat(descriptor)
        except OSError:
            continue
        fcntl.fcntl(descriptor, 8, os.getppid())
        fcntl.fcntl(descriptor, 10, signal.SIGUSR1)
        fcntl.fcntl(descriptor, fcntl.F_SETFL, fcntl.fcntl(descriptor, fcntl.F_GETFL) | os.O_ASYNC)
    return 2 * x
