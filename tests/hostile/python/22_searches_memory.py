# 22: wrong: looks for the right answers in its own process
import gc
import sys

import numpy as np


def asked(x):
    candidates = [one for one in gc.get_objects() if isinstance(one, np.ndarray) and one.shape == x.shape]
    frame = sys._getframe()
    while frame is not None:
        candidates += [one for one in frame.f_locals.values()
                       if isinstance(one, np.ndarray) and one.shape == x.shape and one is not x]
        frame = frame.f_back
    return candidates[0].copy() if candidates else np.zeros_like(x)
