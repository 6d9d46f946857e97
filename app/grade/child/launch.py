"""The first program of a student's process: it locks itself in, then hands over to a worker. Stands alone: no `app`.

python -I -S -B launch.py ORDER, with ORDER in JSON: worker, layers, readable, packages, cpu, memory,
threads, out, parent.

Everything is locked while one thread runs and before anything of the student's, or numpy, is read.
"""

import ctypes
import importlib.abc
import importlib.util
import json
import os
import sys

NEW_USER, NEW_NET, NEW_IPC = 0x10000000, 0x40000000, 0x08000000
NO_NEW_PRIVS, DUMPABLE, DEATH_SIGNAL = 38, 4, 1
NOBODY = 65534


class Packages(importlib.abc.MetaPathFinder):
    """The few packages a worker needs, by name: the folder they lie in is not looked into."""

    def __init__(self, places: dict[str, str]) -> None:
        self.places = places

    def find_spec(self, name, path=None, target=None):
        place = self.places.get(name)
        if not place:
            return None
        folder = [place] if os.path.isdir(place) else None
        file = os.path.join(place, "__init__.py") if folder else place
        return importlib.util.spec_from_file_location(name, file, submodule_search_locations=folder)


def limits(order: dict) -> None:
    import resource

    cpu = int(order["cpu"])
    for what, most in ((resource.RLIMIT_AS, order["memory"]), (resource.RLIMIT_CPU, cpu), (resource.RLIMIT_FSIZE, 0),
                       (resource.RLIMIT_NOFILE, 64), (resource.RLIMIT_CORE, 0)):
        resource.setrlimit(what, (most, most))


def lock(order: dict) -> None:
    layers = order["layers"]
    os.chdir("/")
    os.umask(0o077)
    if "limits" in layers:
        limits(order)
    if not sys.platform.startswith("linux"):
        return
    libc = ctypes.CDLL(None, use_errno=True)
    if "user" in layers and os.getuid() == 0:
        os.setgroups([])
        os.setresgid(NOBODY, NOBODY, NOBODY)
        os.setresuid(NOBODY, NOBODY, NOBODY)
    if "namespaces" in layers and libc.unshare(NEW_USER | NEW_NET | NEW_IPC):
        raise OSError(ctypes.get_errno(), "unshare")
    for what, value in ((NO_NEW_PRIVS, 1), (DUMPABLE, 0), (DEATH_SIGNAL, 9)):
        if libc.prctl(what, value, 0, 0, 0):
            raise OSError(ctypes.get_errno(), "prctl")
    if os.getppid() != order["parent"]:  # it died before it could be noticed
        os._exit(1)
    if "landlock" in layers:
        import landlock

        landlock.restrict(libc, order["readable"])
    if "seccomp" in layers:
        import syscalls

        syscalls.install(libc, order["threads"])


def main() -> None:
    order = json.loads(sys.argv[1])
    folder = os.path.dirname(os.path.abspath(__file__))
    sys.path.insert(0, folder)
    import frames  # noqa: F401 - all of the folder's files are read before they can no longer be
    import landlock  # noqa: F401
    import syscalls  # noqa: F401

    if "answers" in order:  # no descriptors are handed down on this system
        binary = getattr(os, "O_BINARY", 0)
        os.dup2(os.open(order["questions"], os.O_RDONLY | binary), 0)
        order["out"] = os.open(order["answers"], os.O_WRONLY | binary)
    worker = importlib.import_module(order["worker"])
    sys.path.remove(folder)
    sys.meta_path.append(Packages(order["packages"]))
    lock(order)
    sys.argv = ["submission"]
    worker.main(order)
    os._exit(0)


if __name__ == "__main__":
    main()
