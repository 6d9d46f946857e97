# 19: timeout_wall|crash|forbidden: stops, and waits to be waked
import os
import signal


def asked(x):
    os.kill(os.getpid(), signal.SIGSTOP)
