# 24: runtime_error: numbers as text
import numpy as np


def asked(x):
    return np.array([str(2 * one) for one in x])
