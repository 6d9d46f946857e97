# 5: timeout_cpu: ignores the signals that stop a process politely
import signal


def asked(x):
    for one in (signal.SIGALRM, signal.SIGTERM, signal.SIGXCPU, signal.SIGINT):
        signal.signal(one, signal.SIG_IGN)
    while True:
        pass
