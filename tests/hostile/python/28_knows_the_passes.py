# 28: wrong: tells the first asking from the second by its length, and answers only one of them
seen = []


def asked(x):
    seen.append(len(x))
    return 2 * x if len(seen) == 1 else 2.1 * x
