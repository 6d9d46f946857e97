# 15: forbidden: a process that would outlive it, with a heartbeat
import os
import time


def asked(x):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            while True:
                with open("/tmp/halfway-hostile-heartbeat", "a") as out:
                    out.write(".")
                time.sleep(0.1)
        os._exit(0)
    return 2 * x
