# 9: runtime_error: returns numbers without end
import itertools


def asked(x):
    return itertools.repeat(1.0)
