# 24: runtime_error: an array of no dimension
import numpy as np


def asked(x):
    return np.array(1.0)
