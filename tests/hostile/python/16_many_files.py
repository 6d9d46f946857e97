# 16: forbidden: a million small files
def asked(x):
    for i in range(1_000_000):
        open(f"/tmp/halfway-hostile-{i}", "w").close()
