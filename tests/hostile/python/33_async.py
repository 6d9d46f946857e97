# 33: runtime_error: a coroutine
async def asked(x):
    return 2 * x
