# 14: runtime_error: thousands of threads with stacks of nothing, which no limit of memory stops
import threading
import time


def asked(x):
    threading.stack_size(32 << 10)
    for _ in range(1500):
        threading.Thread(target=time.sleep, args=(1e6,), daemon=True).start()
    return 2 * x
