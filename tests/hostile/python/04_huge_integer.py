# 4: timeout_cpu: six million digits, the limit of digits lifted
import sys

sys.set_int_max_str_digits(0)


def asked(x):
    return int("7" * 6_000_000) * x
