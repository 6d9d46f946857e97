# 31: forbidden: a link for the supervisor to follow, a pipe for a file
import os


def asked(x):
    for make in (lambda: os.symlink("/etc/passwd", "/tmp/halfway-hostile-link"),
                 lambda: os.mkfifo("/tmp/halfway-hostile-pipe"), lambda: os.mkdir("/tmp/halfway-hostile-" + "x" * 200),
                 lambda: os.link("/etc/hostname", "/tmp/halfway-hostile-hard")):
        try:
            make()
            return 2 * x
        except PermissionError as error:
            last = error
    raise last
