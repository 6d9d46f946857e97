# 30: forbidden: runs a program another way
import os


def asked(x):
    os.posix_spawn("/bin/touch", ["touch", "/tmp/halfway-hostile-spawn"], {})
    return 2 * x
