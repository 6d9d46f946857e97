# 20: runtime_error: an exception of its own kind whose words never come
class Endless(BaseException):
    def __str__(self):
        while True:
            pass

    __repr__ = __str__


def asked(x):
    raise Endless(Endless())
