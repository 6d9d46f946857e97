# 32: output_limit|timeout_cpu: prints without end
import os


def asked(x):
    while True:
        os.write(1, b"x" * 65536)
