# 14: runtime_error|memory: 100 000 threads
import threading
import time


def asked(x):
    for _ in range(100_000):
        threading.Thread(target=time.sleep, args=(1e6,), daemon=True).start()
    return 2 * x
