# 30: forbidden: becomes a program
import os


def asked(x):
    os.execv("/bin/true", ["true"])
