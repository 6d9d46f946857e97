# 34: compile_error: tabs and spaces
def asked(x):
	if True:
        return 2 * x
