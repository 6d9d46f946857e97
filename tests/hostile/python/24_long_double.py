# 24: runtime_error: wider than a double
import numpy as np


def asked(x):
    return 2 * x.astype(np.longdouble)
