# 23: wrong: patches numpy, builtins, json, struct, time and the worker
import builtins
import json
import os
import struct
import sys
import time

import numpy as np

right = np.allclose
np.allclose = np.array_equal = np.isfinite = lambda *args, **kwargs: True
np.abs = lambda x: 0 * x
builtins.abs = builtins.max = lambda *args: 0
json.dumps = json.loads = lambda *args, **kwargs: "{}"
struct.pack = lambda *args: b"HALF"
time.monotonic = time.process_time = lambda: 0.0
os.write = lambda descriptor, data: len(data)
for name in ("frames", "worker_python", "__main__"):
    for key in list(vars(sys.modules[name])):
        if callable(getattr(sys.modules[name], key)) and not key.startswith("__"):
            try:
                setattr(sys.modules[name], key, lambda *args, **kwargs: None)
            except Exception:
                pass


def asked(x):
    return 0 * x
