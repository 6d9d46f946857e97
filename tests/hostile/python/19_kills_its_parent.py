# 19: forbidden: would end the supervisor
import os
import signal


def asked(x):
    os.kill(os.getppid(), signal.SIGKILL)
