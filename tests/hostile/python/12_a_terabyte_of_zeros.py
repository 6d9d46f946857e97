# 12: memory: zeros for 8 TB
import numpy as np


def asked(x):
    zeros = np.zeros(10**12)
    zeros[::512] = 1.0
    return zeros
