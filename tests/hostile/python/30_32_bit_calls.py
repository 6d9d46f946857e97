# 30: crash: asks the kernel as a 32-bit program does, whose numbers are others
import ctypes
import mmap
import platform


def asked(x):
    code = mmap.mmap(-1, 4096, prot=mmap.PROT_READ | mmap.PROT_WRITE | mmap.PROT_EXEC)
    code.write(b"\xb8\x02\x00\x00\x00\xcd\x80\xc3" if platform.machine() == "x86_64" else b"\x00\x00\x00\x00")
    place = ctypes.addressof(ctypes.c_char.from_buffer(code))
    ctypes.CFUNCTYPE(ctypes.c_int)(place)()  # int 0x80 with the number of fork
    return 2 * x
