# 7: timeout_wall: closes every way out, then sleeps
import os
import time


def asked(x):
    os.closerange(0, 64)
    time.sleep(1e9)
