# 22: forbidden: opens anew, through /proc, what it holds
import os


def asked(x):
    for name in os.listdir("/proc/self/fd"):
        try:
            where = os.readlink(f"/proc/self/fd/{name}")
            os.open(f"/proc/self/fd/{name}", os.O_RDWR)
        except OSError:
            continue
        if not where.startswith(("/dev/null", "pipe:")):
            return 2 * x
    raise PermissionError(1, "none")
