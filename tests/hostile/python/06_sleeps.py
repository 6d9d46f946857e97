# 6: timeout_wall: sleeps
import time


def asked(x):
    time.sleep(1e9)
