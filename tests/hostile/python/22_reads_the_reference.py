# 22: forbidden: reads the reference, from where the worker lies
import sys
from pathlib import Path


def asked(x):
    worker = Path(sys.modules["frames"].__file__)
    return len((worker.parents[2] / "optics" / "fresnel.py").read_text()) * x
