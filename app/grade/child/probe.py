"""Tries, in a locked process, everything a student's text must not do, and the three things it must be able to.

One JSON object on the pipe: what was tried -> "denied", or what happened instead. `app.grade.level` judges it.
"""

import ctypes
import errno
import json
import os
import platform
import socket
import sys
import threading

CONTEXT = {"backend": "egl", "libgl": "libGL.so.1", "libegl": "libEGL.so.1"}  # by name: a search is a process
DENIED = "denied"
CLONE3 = 435
SHMGET = {"x86_64": 29, "aarch64": 194}
DOUBLE = "#version 330 core\nin float x;\nout float y;\nvoid main() { y = x + x; }\n"


def fork() -> None:
    pid = os.fork()
    if pid == 0:
        os._exit(0)
    os.waitpid(pid, 0)


def clone3() -> None:
    ctypes.set_errno(0)
    ctypes.CDLL(None, use_errno=True).syscall(CLONE3, None, ctypes.c_size_t(0))
    if ctypes.get_errno() in (errno.ENOSYS, errno.EPERM):
        raise PermissionError


def execute() -> None:
    try:
        os.execv("/nonexistent", ["x"])
    except FileNotFoundError:
        return  # it would have gone on


def shared_memory() -> None:
    ctypes.set_errno(0)
    number = ctypes.CDLL(None, use_errno=True).syscall(SHMGET.get(platform.machine(), 194), 0, ctypes.c_size_t(1), 0)
    if number < 0:
        raise PermissionError
    ctypes.CDLL(None).shmctl(number, 0, None)


def connect(family: int, kind: int, address) -> None:
    with socket.socket(family, kind) as one:
        one.settimeout(1)
        one.connect(address)
        one.send(b"x")


def read(path: str) -> None:
    with open(path, "rb") as file:
        file.read(1)


def create(path: str) -> None:
    with open(path, "xb"):
        pass
    os.unlink(path)


def signal_by_pipe(parent: int) -> None:
    """Have the kernel signal the supervisor whenever it reads: F_SETOWN, F_SETSIG."""
    import fcntl

    fcntl.fcntl(1, fcntl.F_SETOWN, parent)
    fcntl.fcntl(1, 10, 0)


def many_files() -> None:
    kept = [os.open("/dev/null", os.O_RDONLY) for _ in range(100)]
    for one in kept:
        os.close(one)


def same_network(mine: str) -> None:
    if os.readlink("/proc/self/ns/net") != mine:
        raise PermissionError


def tried(action, *args) -> str:
    try:
        action(*args)
    except (OSError, MemoryError):
        return DENIED
    except BaseException as error:
        return type(error).__name__
    return "it could"


def works(action) -> str:
    try:
        return str(action())
    except BaseException as error:
        return f"{type(error).__name__}: {error}"[:200]


def thread() -> str:
    done: list[int] = []
    one = threading.Thread(target=done.append, args=(1,))
    one.start()
    one.join()
    return "works" if done else "no thread ran"


def numbers() -> str:
    import numpy

    return "works" if float(numpy.hypot(3.0, 4.0)) == 5.0 else "numpy computes wrongly"


def picture() -> str:
    import moderngl  # noqa: TID251 - a process of its own, which cannot import app.gpu
    import numpy

    names: dict = CONTEXT if sys.platform.startswith("linux") else {}
    ctx = moderngl.create_context(standalone=True, require=330, **names)
    ctx.simple_framebuffer((1, 1)).use()
    given = numpy.arange(100, dtype="<f4")
    out = ctx.buffer(reserve=400)
    program = ctx.program(vertex_shader=DOUBLE, varyings=("y",))
    ctx.vertex_array(program, [(ctx.buffer(given), "1f", "x")]).transform(out, moderngl.POINTS, 100)
    got = numpy.frombuffer(out.read(), "<f4")
    right = bool((got == 2 * given).all())
    return f"works: {ctx.info['GL_RENDERER']}; {ctx.info['GL_VERSION']}" if right else "wrong numbers"


def main(order: dict) -> None:
    if order.get("spin"):
        while True:
            pass
    folder, parent = order["folder"], order["parent"]
    found = {name: works(action) for name, action in (("thread", thread), ("numpy", numbers), ("picture", picture))}
    local = ("127.0.0.1", order["port"])
    found |= {name: tried(action, *args) for name, action, *args in (
        ("start a process (fork)", fork), ("start a process (clone3)", clone3), ("run a program", execute),
        ("run a program (posix_spawn)", os.posix_spawn, "/bin/true", ["true"], {}),
        ("reach a TCP port", connect, socket.AF_INET, socket.SOCK_STREAM, local),
        ("send UDP", connect, socket.AF_INET, socket.SOCK_DGRAM, local),
        ("reach a UNIX socket", connect, socket.AF_UNIX, socket.SOCK_STREAM, order["unix"]),
        ("reach an abstract socket", connect, socket.AF_UNIX, socket.SOCK_STREAM, "\0" + order["abstract"]),
        ("see the network", same_network, order["network"]),
        ("read a file beside the answers", read, f"{folder}/canary"),
        ("read the course's files", read, order["source"]),
        ("read the supervisor's memory map", read, f"/proc/{parent}/maps"), ("list a folder", os.listdir, folder),
        ("write a file", create, f"{folder}/new"), ("change a file's mode", os.chmod, f"{folder}/canary", 0o644),
        ("share memory (memfd)", os.memfd_create, "x"), ("share memory (shmget)", shared_memory),
        ("signal the supervisor", os.kill, parent, 0), ("signal it through a pipe", signal_by_pipe, parent),
        ("open many files", many_files),
        ("take much memory", bytearray, order["memory"] + (1 << 20)))}
    data = json.dumps(found).encode()
    while data:
        data = data[os.write(order["out"], data):]
