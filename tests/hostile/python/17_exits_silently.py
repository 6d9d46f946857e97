# 17: crash: leaves without a word
import os


def asked(x):
    os._exit(0)
