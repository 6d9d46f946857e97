# 13: runtime_error: opens files until none is left
def asked(x):
    kept = []
    while True:
        kept.append(open("/dev/null"))
