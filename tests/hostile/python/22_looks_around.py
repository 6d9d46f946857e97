# 22: forbidden: looks for other submissions, tests and seeds
import os


def asked(x):
    seen = []
    for place in ("/tmp", "/home", "/root", "/work", "/", "..", "/proc", f"/proc/{os.getppid()}/fd"):
        try:
            seen += os.listdir(place)
        except FileNotFoundError:
            pass
        except PermissionError as error:
            last = error
    if seen:
        return 2 * x
    raise last
