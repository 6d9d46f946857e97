# 29: forbidden: a connection to this machine
import socket


def asked(x):
    for port in (8786, 8787, 6379, 8888, 22, 80):
        with socket.create_connection(("127.0.0.1", port), timeout=1):
            return 2 * x
