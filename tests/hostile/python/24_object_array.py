# 24: runtime_error: an array of objects
import numpy as np


def asked(x):
    return np.array([float(one) * 2 for one in x], object)
