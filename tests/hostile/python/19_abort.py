# 19: crash: aborts
import os


def asked(x):
    os.abort()
