# 18: crash: dies while it is read, in the words of a sandbox that cannot be set up
import os
import sys

print('  File "launch.py", line 1\nOSError: unshare', file=sys.stderr, flush=True)
os._exit(1)
