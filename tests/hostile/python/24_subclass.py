# 24: runtime_error: a kind of array of its own
import numpy as np


class Mine(np.ndarray):
    def __array_finalize__(self, other):
        pass

    def tobytes(self, *args):
        return b""


def asked(x):
    return (2 * x).view(Mine)
