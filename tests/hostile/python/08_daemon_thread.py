# 8: runtime_error: right, but by a thread; functions of numbers start none
import threading
import time


def forever():
    while True:
        time.sleep(0.001)


def asked(x):
    threading.Thread(target=forever, daemon=True).start()
    return 2 * x
