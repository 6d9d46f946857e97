# 24: runtime_error: an array that hides its values
import numpy as np


def asked(x):
    return np.ma.masked_array(2 * x, mask=True)
