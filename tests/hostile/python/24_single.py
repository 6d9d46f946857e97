# 24: pass: single precision: every one of its numbers is a double
import numpy as np


def asked(x):
    return 2 * x.astype(np.float32)
