# 18: runtime_error|crash: leaves while it is read
import sys

sys.exit(0)
