"""Hostile texts of thousands of lines, made as they are asked for; each by what would be its path below `hostile`."""

DEEP, MANY = 1500, 1000

CONDITIONS = "".join((
    f"// 41: pass|crash|timeout_cpu|memory|compile_error: {DEEP} branches within one another\n",
    "float asked(float x) {\n    float y = 2.0 * x;\n",
    "    if (x > -1.0) {\n" * DEEP, "    y += 0.0;\n", "    }\n" * DEEP, "    return y;\n}\n"))
OVERLOADS = "".join((
    f"// 41: pass|timeout_cpu|memory|crash|compile_error: {MANY} functions of one name\n",
    *(f"struct S{i} {{ float x; }};\nfloat f(S{i} s) {{ return s.x; }}\n" for i in range(MANY)),
    "float asked(float x) { return f(S7(2.0 * x)); }\n"))
TEXTS = {"glsl/41_conditions.glsl": CONDITIONS, "glsl/41_overloads.glsl": OVERLOADS}
