# 16: forbidden: would have the machine write out its disks again and again
import ctypes


def asked(x):
    libc = ctypes.CDLL(None, use_errno=True)
    for _ in range(3):
        if libc.syscall(ctypes.c_long(306), 0):
            raise PermissionError(ctypes.get_errno(), "syncfs")
    return 2 * x
