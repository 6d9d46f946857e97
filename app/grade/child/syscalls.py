"""What a student's process may not ask of the kernel, as a filter of the kernel's own (seccomp, classic BPF).

A denied call fails with EPERM, which Python shows as PermissionError. Numbers newer than the newest looked at here do
not exist as far as the process can see. Written out, because the wheels of a library for it bring no libseccomp along.
Sources: seccomp(2), linux/filter.h, the kernel's tables of system calls for x86-64 and arm64.
"""

import ctypes
import errno
import os
import platform
import struct

NEWEST = 452  # fchmodat2, Linux 6.6
# name=x86-64/arm64: sockets; processes and signals; keys, io_uring, tracing; mounts; memory that others can see;
# what Landlock does not hold (modes, owners, times, names); other users; the machine
DENIED = """
socket=41/198 socketpair=53/199 connect=42/203 bind=49/200 listen=50/201 accept=43/202 accept4=288/242
sendto=44/206 recvfrom=45/207 sendmsg=46/211 recvmsg=47/212 sendmmsg=307/269 recvmmsg=299/243 shutdown=48/210
getsockopt=55/209 setsockopt=54/208 getsockname=51/204 getpeername=52/205 execve=59/221 execveat=322/281 fork=57/-
vfork=58/- tkill=200/130 rt_sigqueueinfo=129/138 rt_tgsigqueueinfo=297/240 pidfd_open=434/434 pidfd_getfd=438/438
pidfd_send_signal=424/424 process_madvise=440/440 process_mrelease=448/448 ptrace=101/117 process_vm_readv=310/270
process_vm_writev=311/271 kcmp=312/272 setrlimit=160/164 keyctl=250/219 add_key=248/217 request_key=249/218
io_uring_setup=425/425 io_uring_enter=426/426 io_uring_register=427/427 bpf=321/280 userfaultfd=323/282
perf_event_open=298/241 mount=165/40 umount2=166/39 pivot_root=155/41 fsopen=430/430 fsconfig=431/431
fsmount=432/432 fspick=433/433 move_mount=429/429 open_tree=428/428 mount_setattr=442/442 unshare=272/97
setns=308/268 chroot=161/51 memfd_create=319/279 memfd_secret=447/447 shmget=29/194 shmat=30/196 shmctl=31/195
shmdt=67/197 semget=64/190 semop=65/193 semctl=66/191 semtimedop=220/192 msgget=68/186 msgsnd=69/189 msgrcv=70/188
msgctl=71/187 mq_open=240/180 mq_unlink=241/181 mq_timedsend=242/182 mq_timedreceive=243/183 mq_notify=244/184
mq_getsetattr=245/185 inotify_init=253/- inotify_init1=294/26 inotify_add_watch=254/27 fanotify_init=300/262
fanotify_mark=301/263 setsid=112/157 setpgid=109/154 chmod=90/- fchmod=91/52 fchmodat=268/53 fchmodat2=452/452
chown=92/- fchown=93/55 lchown=94/- fchownat=260/54 utime=132/- utimes=235/- utimensat=280/88 futimesat=261/-
truncate=76/45 ftruncate=77/46 setxattr=188/5 lsetxattr=189/6 fsetxattr=190/7 removexattr=197/14
lremovexattr=198/15 fremovexattr=199/16 mknod=133/- mknodat=259/33 mkdir=83/- mkdirat=258/34 rmdir=84/-
unlink=87/- unlinkat=263/35 rename=82/- renameat=264/38 renameat2=316/276 link=86/- linkat=265/37 symlink=88/-
symlinkat=266/36 creat=85/- setuid=105/146 setgid=106/144 setreuid=113/145 setregid=114/143 setresuid=117/147
setresgid=119/149 setgroups=116/159 setfsuid=122/151 setfsgid=123/152 capset=126/91 sched_setscheduler=144/119
sched_setparam=142/118 sched_setattr=314/274 sched_setaffinity=203/122 setpriority=141/140 ioprio_set=251/30
name_to_handle_at=303/264 open_by_handle_at=304/265 quotactl=179/60 quotactl_fd=443/443 acct=163/89 swapon=167/224
swapoff=168/225
reboot=169/142 sethostname=170/161 setdomainname=171/162 init_module=175/105 finit_module=313/273
delete_module=176/106 kexec_load=246/104 kexec_file_load=320/294 settimeofday=164/170 clock_settime=227/112
clock_adjtime=305/266 adjtimex=159/171 personality=135/92 modify_ldt=154/- ioperm=173/- iopl=172/- syslog=103/116
lookup_dcookie=212/18 vhangup=153/58 uselib=134/- ustat=136/- sysfs=139/- nfsservctl=180/42 migrate_pages=256/238
move_pages=279/239 landlock_create_ruleset=444/444 seccomp=317/277 futex_waitv=449/449
set_mempolicy_home_node=450/450 sync=162/81 syncfs=306/267
"""
SPECIAL = {"clone": (56, 220), "clone3": (435, 435), "kill": (62, 129), "tgkill": (234, 131), "prctl": (157, 167),
           "prlimit64": (302, 261), "fcntl": (72, 25), "ioctl": (16, 29)}
MACHINES = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}  # column above, AUDIT_ARCH_*
LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06  # BPF_LD|W|ABS, BPF_JMP|JEQ, |JGE, |JSET, BPF_RET
ALLOW, KILL_PROCESS = 0x7FFF0000, 0x80000000
EPERM, ENOSYS = 0x00050000 | errno.EPERM, 0x00050000 | errno.ENOSYS
NUMBER, ARCHITECTURE = 0, 4  # offsets in struct seccomp_data
CLONE_THREAD = 0x00010000
HARMLESS_PRCTL = (3, 15, 16, 0x53564D41)  # get dumpable, set and get a thread's name, name memory
HARMLESS_IOCTL = (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451)  # is it a terminal, its size, bytes to read, flags
FCNTL_THAT_SIGNALS = (8, 10, 15, 1024, 1026)  # F_SETOWN, F_SETSIG, F_SETOWN_EX, F_SETLEASE, F_NOTIFY: kill by a pipe


def argument(n: int, high: bool = False) -> int:
    return 16 + 8 * n + (4 if high else 0)


def program(pid: int, machine: str, threads: bool) -> bytes:
    """The filter; every rule is a comparison that skips its answer when it does not hold.

    threads: whether it may start some. A function of numbers needs none, and no limit bounds small ones for root.
    """
    column, arch = MACHINES[machine]
    code: list[tuple[int, int, int, int]] = []

    def step(what: int, value: int, yes: int = 0, no: int = 0) -> None:
        code.append((what, yes, no, value))

    def rule(number: int, *body: tuple[int, int, int, int]) -> None:
        step(LOAD, NUMBER)
        step(EQUAL, number, 0, len(body))
        code.extend(body)

    step(LOAD, ARCHITECTURE)
    step(EQUAL, arch, 1, 0)
    step(RETURN, KILL_PROCESS)
    step(LOAD, NUMBER)
    step(AT_LEAST, NEWEST + 1, 0, 1)
    step(RETURN, ENOSYS)
    for pair in DENIED.split():
        number = pair.partition("=")[2].split("/")[column]
        if number != "-":
            step(EQUAL, int(number), 0, 1)
            step(RETURN, EPERM)
    rule(SPECIAL["clone3"][column], (RETURN, 0, 0, ENOSYS))  # the C library then uses clone, whose flags can be seen
    rule(SPECIAL["clone"][column], (LOAD, 0, 0, argument(0)), (ANY_BIT, 1, 0, CLONE_THREAD if threads else 0),
         (RETURN, 0, 0, EPERM), (RETURN, 0, 0, ALLOW))
    for name in ("kill", "tgkill"):  # itself only: abort() needs it
        rule(SPECIAL[name][column], (LOAD, 0, 0, argument(0)), (EQUAL, 1, 0, pid), (RETURN, 0, 0, EPERM),
             (RETURN, 0, 0, ALLOW))
    rule(SPECIAL["prlimit64"][column], (LOAD, 0, 0, argument(2)), (EQUAL, 1, 0, 0), (RETURN, 0, 0, EPERM),
         (LOAD, 0, 0, argument(2, high=True)), (EQUAL, 1, 0, 0), (RETURN, 0, 0, EPERM), (RETURN, 0, 0, ALLOW))
    for name, place, words, listed, other in (("prctl", 0, HARMLESS_PRCTL, ALLOW, EPERM),
                                              ("ioctl", 1, HARMLESS_IOCTL, ALLOW, EPERM),
                                              ("fcntl", 1, FCNTL_THAT_SIGNALS, EPERM, ALLOW)):
        rule(SPECIAL[name][column], (LOAD, 0, 0, argument(place)),
             *((EQUAL, len(words) - i, 0, word) for i, word in enumerate(words)),
             (RETURN, 0, 0, other), (RETURN, 0, 0, listed))
    step(RETURN, ALLOW)
    return b"".join(struct.pack("<HBBI", *line) for line in code)


def install(libc: ctypes.CDLL, threads: bool) -> None:
    """For this thread and all it starts; needs no_new_privs."""
    text = program(os.getpid(), platform.machine(), threads)
    filters = ctypes.create_string_buffer(text, len(text))
    head = ctypes.create_string_buffer(struct.pack("<HxxxxxxQ", len(text) // 8, ctypes.addressof(filters)))
    if libc.prctl(22, 2, ctypes.c_ulong(ctypes.addressof(head)), 0, 0):  # PR_SET_SECCOMP, SECCOMP_MODE_FILTER
        raise OSError(ctypes.get_errno(), "seccomp")
