# 24: pass: every second number of an array, from its end
import numpy as np


def asked(x):
    wide = np.zeros(2 * len(x))
    wide[::2] = 2 * x[::-1]
    return wide[::2][::-1]
