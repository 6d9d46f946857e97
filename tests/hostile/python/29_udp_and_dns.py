# 29: forbidden: a name looked up, a datagram
import socket


def asked(x):
    with socket.socket(socket.AF_INET6, socket.SOCK_DGRAM) as one:
        one.sendto(b"x", ("::1", 53))
    socket.getaddrinfo("localhost", 80)
    return 2 * x
