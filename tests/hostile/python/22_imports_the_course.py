# 22: runtime_error|forbidden: imports the reference
def asked(x):
    import app.optics

    return 2 * x
