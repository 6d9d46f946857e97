# 16: forbidden: would freeze a file system, or change its attributes
import fcntl


def asked(x):
    for number in (0xC0045877, 0xC0045878, 0x40086602):
        fcntl.ioctl(0, number, bytes(8))
    return 2 * x
