# 25: nonfinite: no number at all
import numpy as np


def asked(x):
    return np.frombuffer(np.full(len(x), 0x7FF8DEADBEEF0001, np.uint64).tobytes(), float)
