# 8: pass: right, and spins in every place that runs at the end
import atexit
import threading


def spin(*_):
    while True:
        pass


class Clinging:
    __del__ = spin


kept = Clinging()
atexit.register(spin)


def asked(x):
    return 2 * x
