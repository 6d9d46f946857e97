# 30: forbidden: the same by number, past the C library
import ctypes


def asked(x):
    libc = ctypes.CDLL(None, use_errno=True)
    for number, *args in ((57,), (58,), (56, 17, 0, 0, 0, 0), (435, 0, 0), (41, 2, 1, 0), (319, b"x", 0), (101, 0, 0, 0),
                          (272, 0x10000000), (165, 0, 0, 0, 0, 0), (157, 4, 1, 0, 0, 0), (0x40000000 + 57,)):
        if libc.syscall(ctypes.c_long(number), *args) >= 0:
            return 2 * x
    raise PermissionError(ctypes.get_errno(), "none of them")
