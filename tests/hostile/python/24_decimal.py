# 24: runtime_error: decimals
from decimal import Decimal


def asked(x):
    return [Decimal(2) * Decimal(one) for one in x]
