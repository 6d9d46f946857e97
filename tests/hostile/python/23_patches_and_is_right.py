# 23: pass: patches what the worker could use, and is right
import json
import os
import struct

import numpy as np

np.array = np.asarray = np.frombuffer = lambda *args, **kwargs: None
os.write = os.pread = json.dumps = struct.pack = None


def asked(x):
    return 2 * x
