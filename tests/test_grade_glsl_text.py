"""What of GLSL is refused before a compiler sees it, with the student's line; and what is not."""

import numpy as np
import pytest

from app.grade import glsl_text
from app.grade.question import Question

ASKED = Question("f", "f", "glsl", {"x": np.zeros(1)})


@pytest.mark.parametrize("text", [
    "float f(float x) { return x; }", "const float PI = 3.14;\nfloat g(float, float);\nfloat f(float x) { return PI; }",
    "struct S { float a; };\nS make(float x) { return S(x); }\nfloat f(float x) { return make(x).a; }",
    "const float A[3] = float[3](1.0, 2.0, 3.0);\nfloat f(float x) { return A[1] * x; }",
    "const float\n  A = 1.0,\n  B = 2.0;\nfloat f(in float x) { float texture_scale = 2.0; return A * B * x; }",
    "precision highp float;\nhighp float f(const in highp float x) { return x; }", ";;float f(float x){return x;};",
    "float f(float x) { float sample = x, patch = 2.0, buffer = 1.0; return sample * patch; }",
    "void halves(float x, out float y) { y = 0.5 * x; }\nfloat f(float x) { float y; halves(x, y); return y; }",
    "/* #define */ float f(float x) { return 1.0e-5 * x + .5; } // \\ texture(x) ' \" é",
])
def test_ordinary_text_passes(text):
    assert glsl_text.fault(text) == ("", "") and glsl_text.signature_fault(text, ASKED) == ("", "")


@pytest.mark.parametrize(("text", "line", "word"), [
    ("float f(float x) {\n return x;\n}\nfloat k = 1.0;", 4, "k: a variable"), ("float x[2];", 1, "x: a variable"),
    ("\nbuffer Data { float a[]; };", 2, "buffer"), ("shared float a;", 1, "shared"), ("in float a;", 1, "in:"),
    ("\n\nuniform float a;", 3, "uniform"), ("float f(float x) {\n return texture(s, x).x; }", 2, "texture"),
    ("float f(float x) { return float(\ngl_VertexID); }", 2, "gl_VertexID"), ("float a__b(float x) {}", 1, "a__b"),
    ("\nvoid main() {}", 2, "main"), ("\nfloat sqrt(float x) { return x; }", 2, "sqrt"), ("float ä;", 1, "ä"),
    ("x # y", 1, "#"), ("a\\\nb", 1, "\\"), ("float f(float x) {\n float y = dFdx(x); }", 2, "dFdx"),
])
def test_what_is_refused_is_told_by_its_line(text, line, word):
    verdict, said = glsl_text.fault(text)
    assert verdict == "rejected" and said.startswith(f"submission.glsl, line {line}: ") and word in said


@pytest.mark.parametrize(("text", "line"), [
    ("float f(float x) {\n return (x;\n}", 2), ("{", 1), ("}", 1), ("a\n)", 2), ("(\n[\n)", 2), ("a\n/* b", 2),
    ("/*/", 1)])
def test_brackets_and_comments_are_counted(text, line):
    verdict, said = glsl_text.fault(text)
    assert verdict == "compile_error" and said.startswith(f"submission.glsl, line {line}: ")


@pytest.mark.parametrize(("text", "verdict"), [
    ("float g(float x) { return x; }", "missing"), ("float F(float x) { return x; }", "missing"),
    ("float f(float x);", "missing"), ("float f(vec2 x) { return x.x; }", "compile_error"),
    ("vec2 f(float x) { return vec2(x); }", "compile_error"), ("float f(out float x) { return x; }", "compile_error"),
    ("float f(float x, float y) { return x; }", "compile_error"),
    ("float f(float x) { return x; }\nfloat f(vec2 x) { return x.x; }", "rejected")])
def test_the_asked_signature_is_there_once(text, verdict):
    got, said = glsl_text.signature_fault(text, ASKED)
    assert got == verdict and said


def test_comments_become_white_space_and_lines_stay():
    assert glsl_text.plain("a /* b\nc */ d // e\nf") == "a     \n     d     \nf"
