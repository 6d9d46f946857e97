# 9: runtime_error: an object whose conversion never ends: it is not converted
class Number:
    def __array__(self, *args, **kwargs):
        while True:
            pass

    __float__ = __len__ = __iter__ = __array__


def asked(x):
    return Number()
