# 19: forbidden: would end whatever it may
import os
import signal


def asked(x):
    try:
        os.kill(-1, signal.SIGKILL)
    except PermissionError:
        os.killpg(0, signal.SIGKILL)
