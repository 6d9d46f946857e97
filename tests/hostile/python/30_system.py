# 30: wrong: runs a program a third way, and learns nothing
import os


def asked(x):
    return 2 * x if os.system("touch /tmp/halfway-hostile-system") == 0 else 0 * x
