# 20: runtime_error: an exception that cannot be told
class Silent(Exception):
    def __str__(self):
        raise Silent

    __repr__ = __getattribute__ = __str__


def asked(x):
    raise Silent
