"""Which files a student's process may read; it may write none, and no network but what is named. By raw system calls.

Sources: landlock(7), linux/landlock.h. What the running kernel does not know is left out of the request; the self-test
of the sandbox tells whether that matters.
"""

import ctypes
import os
import struct

CREATE, ADD, RESTRICT = 444, 445, 446
READ_FILE, READ_DIR = 1 << 2, 1 << 3
FILE_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}  # ABI -> how many rights of files it knows
TCP, SCOPES = 0b11, 0b11  # bind and connect; abstract sockets and signals
SIZES = {1: 8, 2: 8, 3: 8, 4: 16, 5: 16}  # bytes of the attribute; 24 from ABI 6 on


def abi(libc: ctypes.CDLL) -> int:
    return max(libc.syscall(CREATE, None, ctypes.c_size_t(0), 1), 0)


def restrict(libc: ctypes.CDLL, readable: list[str]) -> None:
    """From here on only what lies at or below `readable` can be opened, and only for reading."""
    version = abi(libc)
    if not version:
        raise OSError(ctypes.get_errno(), "landlock")
    known = min(version, 6)
    rights = (1 << FILE_RIGHTS.get(known, 16)) - 1
    wanted = struct.pack("<QQQ", rights, TCP if known >= 4 else 0, SCOPES if known >= 6 else 0)
    attribute = wanted[:SIZES.get(known, 24)]
    ruleset = libc.syscall(CREATE, attribute, ctypes.c_size_t(len(attribute)), 0)
    if ruleset < 0:
        raise OSError(ctypes.get_errno(), "landlock_create_ruleset")
    for path in readable:
        try:
            place = os.open(path, os.O_PATH | os.O_CLOEXEC)
        except OSError:
            continue  # not on this machine
        allowed = READ_FILE | READ_DIR if os.path.isdir(path) else READ_FILE
        rule = struct.pack("<Qi", allowed, place)
        if libc.syscall(ADD, ruleset, 1, rule, 0):
            raise OSError(ctypes.get_errno(), f"landlock_add_rule {path}")
        os.close(place)
    if libc.syscall(RESTRICT, ruleset, 0):
        raise OSError(ctypes.get_errno(), "landlock_restrict_self")
    os.close(ruleset)
