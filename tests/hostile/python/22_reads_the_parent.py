# 22: forbidden: reads the supervisor's memory
import os


def asked(x):
    with open(f"/proc/{os.getppid()}/mem", "rb") as memory:
        memory.seek(0x400000)
        return len(memory.read(16)) * x
