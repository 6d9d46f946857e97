# 28: wrong: the answer depends on the point's place
import numpy as np


def asked(x):
    return 2 * x + np.arange(len(x))
