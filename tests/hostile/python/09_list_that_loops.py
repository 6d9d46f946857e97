# 9: runtime_error: a list of objects whose conversion never ends
class Number:
    def __float__(self):
        while True:
            pass


def asked(x):
    return [Number()] * len(x)
