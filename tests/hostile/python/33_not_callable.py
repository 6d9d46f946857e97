# 33: runtime_error: a number
asked = 2.0
