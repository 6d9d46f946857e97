# 10: forbidden|runtime_error: lifts its own limits first
import resource


def asked(x):
    resource.setrlimit(resource.RLIMIT_AS, (-1, -1))
    return 2 * x
