# 8: pass: right, and a thread goes on
import threading
import time


def forever():
    while True:
        time.sleep(0.001)


def asked(x):
    threading.Thread(target=forever, daemon=True).start()
    return 2 * x
