# 19: crash: reads where nothing is
import ctypes


def asked(x):
    return ctypes.string_at(0)
