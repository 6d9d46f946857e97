# 14: forbidden: a thread by the number of clone
import ctypes


def asked(x):
    stack = ctypes.create_string_buffer(1 << 16)
    libc = ctypes.CDLL(None, use_errno=True)
    entry = ctypes.cast(libc.pause, ctypes.c_void_p)
    top = ctypes.c_void_p(ctypes.addressof(stack) + (1 << 16) - 64)
    if libc.clone(entry, top, 0x100 | 0x200 | 0x400 | 0x800 | 0x10000, None) < 0:
        raise PermissionError(ctypes.get_errno(), "clone")
    return 2 * x
