# 28: wrong: chance
import numpy as np


def asked(x):
    return 2 * x * np.random.default_rng().choice([1.0, 2.0], len(x))
