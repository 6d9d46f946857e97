# 29: forbidden: doors of this machine, by path and by name
import socket


def asked(x):
    for address in ("/var/run/docker.sock", "/run/dbus/system_bus_socket", "/tmp/.X11-unix/X0", "\0halfway"):
        with socket.socket(socket.AF_UNIX) as one:
            one.connect(address)
    return 2 * x
