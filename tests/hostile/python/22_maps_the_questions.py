# 22: wrong: rewrites the file of the questions through a mapping; nobody else reads it
import mmap


def asked(x):
    with mmap.mmap(0, 0) as file:
        file[:] = bytes(len(file))
    return 2 * x
