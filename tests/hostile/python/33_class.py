# 33: runtime_error: a class
class asked:
    def __init__(self, x):
        self.value = 2 * x
