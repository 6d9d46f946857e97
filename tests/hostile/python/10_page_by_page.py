# 10: memory|timeout_cpu: takes what it can get by many small mappings
import mmap


def asked(x):
    kept = []
    while True:
        one = mmap.mmap(-1, 64 << 20)
        for place in range(0, len(one), 4096):
            one[place] = 1
        kept.append(one)
