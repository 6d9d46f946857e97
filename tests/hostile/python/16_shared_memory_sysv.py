# 16: forbidden|runtime_error: shared memory, the System V way
import ctypes


def asked(x):
    if ctypes.CDLL(None, use_errno=True).shmget(0x48414C46, ctypes.c_size_t(1 << 28), 0o1666) >= 0:
        return 2 * x
    raise PermissionError(ctypes.get_errno(), "shmget")
