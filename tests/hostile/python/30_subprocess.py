# 30: forbidden: runs a program
import subprocess


def asked(x):
    subprocess.run(["/bin/touch", "/tmp/halfway-hostile-subprocess"], check=True)
    return 2 * x
