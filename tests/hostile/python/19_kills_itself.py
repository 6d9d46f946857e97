# 19: crash: ends itself
import os
import signal


def asked(x):
    os.kill(os.getpid(), signal.SIGKILL)
