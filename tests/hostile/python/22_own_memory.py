# 22: forbidden|pass: rewrites its own memory through /proc; whatever it changes is its own
import ctypes


def asked(x):
    with open("/proc/self/mem", "r+b", buffering=0) as memory:
        memory.seek(x.ctypes.data)
        memory.write(ctypes.string_at(x.ctypes.data, 8))
    return 2 * x
