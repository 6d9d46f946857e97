# 28: wrong: right at the first call only
calls = 0


def asked(x):
    global calls
    calls += 1
    return 2 * x if calls == 1 else 3 * x
