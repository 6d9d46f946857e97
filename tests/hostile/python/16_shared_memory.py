# 16: forbidden: shared memory, the POSIX way
def asked(x):
    from multiprocessing import shared_memory

    shared_memory.SharedMemory("halfway-hostile", create=True, size=1 << 30)
