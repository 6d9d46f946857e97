# 19: forbidden: the same by ioctl (FIOSETOWN)
import ctypes
import os


def asked(x):
    libc = ctypes.CDLL(None, use_errno=True)
    owner = ctypes.c_int(os.getppid())
    answers = [libc.ioctl(descriptor, ctypes.c_ulong(number), ctypes.byref(owner))
               for descriptor in range(1, 8) for number in (0x8901, 0x8902)]
    if 0 not in answers:
        raise PermissionError(1, "FIOSETOWN")
    return 2 * x
