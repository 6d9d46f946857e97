"""Shader text: includes, what is kept and left out, and the way back from a compiler's line to a person's."""

import re
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app import shader
from app.paths import GLSL
from app.problem import Problem
from app.shader import Argument, Source, assemble, resolve, signatures, translate, uniforms


def files(**texts: str) -> dict[str, Source]:
    """Overrides named a.glsl, b.glsl, ... from texts in which @a stands for an include of a.glsl."""
    return {f"{name}.glsl": Source(including(text), f"glsl/{name}.glsl") for name, text in texts.items()}


def including(text: str) -> str:
    return re.sub(r"@(\w+)", r'#include "\1.glsl"', text)


def put_together(text: str, **texts: str) -> shader.Assembled:
    return assemble(including(text), "root", overrides=files(**texts))


# --- includes ------------------------------------------------------------------------------------------------------
def test_includes_go_depth_first_and_each_once():
    lines = resolve(including("@a\n@b\nroot"), "root", overrides=files(a="@c\nin a", b="@c\nin b", c="in c"))
    assert [line.text for line in lines] == ["in c", "in a", "in b", "root"]
    assert [(line.file, line.number) for line in lines] == [("glsl/c.glsl", 1), ("glsl/a.glsl", 2), ("glsl/b.glsl", 2),
                                                            ("root", 3)]


def test_a_circle_is_named_with_file_and_line():
    with pytest.raises(Problem, match=r"glsl/b\.glsl, line 2: a circle of includes: a\.glsl -> b\.glsl -> a\.glsl"):
        resolve(including("@a"), "root", overrides=files(a="@b", b="first\n@a"))
    with pytest.raises(Problem, match=r"line 1: a circle of includes: a\.glsl -> a\.glsl"):
        resolve(including("@a"), "root", overrides=files(a="@a"))


def test_a_missing_include_names_the_includer_and_near_names():
    with pytest.raises(Problem, match=r"lessons/x\.py, line 12: there is no glsl/optics/solid_angel\.glsl\. "
                                      r"Did you mean optics/solid_angle\.glsl"):
        resolve('float x;\n\n#include "optics/solid_angel.glsl"', "lessons/x.py", 10)


@pytest.mark.parametrize("name", ["../app/shader.py", "/etc/hostname", "core/../../README.md", "core"])
def test_nothing_outside_glsl_can_be_included(name):
    with pytest.raises(Problem, match="there is no glsl/"):
        resolve(f'#include "{name}"', "student.glsl")


def test_an_override_replaces_an_included_file_everywhere():
    own = {"core/constants.glsl": Source("const float PI = 3.0;", "student.glsl", 7)}
    made = assemble('#include "optics/spherical.glsl"\nvoid main() { gl_Position = vec4(direction(PI, 0.0), 1.0); }',
                    "root", overrides=own)
    assert "const float PI = 3.0;" in made.text and "3.14159" not in made.text
    assert "student.glsl" in made.files and "glsl/core/constants.glsl" not in made.files
    assert made.lines[0].number == 7


@pytest.mark.parametrize("line", ['/*\n#include "nowhere.glsl"\n*/', '// #include "nowhere.glsl"'])
def test_an_include_in_a_comment_is_none(line):
    assert resolve(line, "root")[0].file == "root"


def test_an_include_may_carry_a_remark_and_a_crooked_one_is_refused():
    assert resolve('#include "core/constants.glsl" // PI', "root")[0].file == "glsl/core/constants.glsl"
    for crooked in ("#include <core/constants.glsl>", '#include "core/constants.glsl', "#include core/constants.glsl"):
        with pytest.raises(Problem, match=r"root, line 2: #include .* is not like #include"):
            resolve(f"\n{crooked}", "root")


@given(st.dictionaries(st.integers(0, 6), st.sets(st.integers(0, 6)), min_size=1))
def test_any_web_of_includes_ends_well(web):
    """Each file once and behind all it includes, or a circle that really is one."""
    texts = files(**{f"f{i}": "\n".join(f"@f{j}" for j in sorted(web.get(i, ()))) + f"\nbody{i}" for i in range(7)})
    try:
        lines = resolve('#include "f0.glsl"', "root", overrides=texts)
    except Problem as problem:
        circle = re.findall(r"f(\d)\.glsl", str(problem).split("a circle of includes:")[1])
        tail = circle[circle.index(circle[-1]):]
        assert len(tail) > 1 and all(int(b) in web[int(a)] for a, b in pairwise(tail))
        return
    order = [int(line.text[4:]) for line in lines if line.text.startswith("body")]
    assert len(order) == len(set(order)) and order[-1] == 0
    assert all(order.index(j) < order.index(i) for i in order for j in web.get(i, ()))


# --- what is kept --------------------------------------------------------------------------------------------------
KEPT = {  # text -> a declaration of it that main reaches, and one it does not
    "functions": ("float one() { return 1.0; }\nfloat two() {\n  return 2.0;\n}\nvoid main() { one(); }", "one", "two"),
    "uniforms": ("uniform float one;\nuniform vec2 two;\nvoid main() { one; }", "one", "two"),
    "arrays": ("uniform vec3 one[13];\nuniform vec3 two[5];\nvoid main() { one[2]; }", "one", "two"),
    "structs": ("struct One { float a; };\nstruct Two { float b; };\nvoid main() { One x; }", "One", "Two"),
    "constants": ("const float one = 1.0;\nconst float two = 2.0 * 3.0;\nvoid main() { one; }", "one", "two"),
    "array constants": ("const float one[2] = float[2](1.0, 2.0);\nconst float[2] two = float[2](1.0, 2.0);\n"
                        "void main() { one[0]; }", "one", "two"),
    "array constants, written otherwise": (
        "const float[2] one = float[2](1.0, 2.0);\nconst float two[1] = float[1](1.0);\nvoid main() { one[0]; }",
        "one", "two"),
    "outputs": ("layout(location = 0) out vec4 one;\nlayout(location = 1) out vec4 two;\nvoid main() { one; }",
                "one", "two"),
    "several lines": ("const vec2 one = vec2(\n  1.0,\n  2.0\n);\nfloat two(float a,\n  float b)\n{\n  return a;\n}\n"
                      "void main() { one; }", "one", "two"),
    "braces in comments": ("float two() { // {{{\n  return 1.0; /* } */\n}\nfloat one() { return 2.0; } // }\n"
                           "void main() { one(); }", "one", "two"),
    "defines": ("#define one 1.0\n#define two 2.0\nvoid main() { one; }", "one", "two"),
    "flat": ("flat in int one;\nflat out int two;\nvoid main() { one; }", "one", "two"),
    "several in a declaration": ("uniform float zero, one;\nuniform float two, three;\nvoid main() { one; }",
                                 "one", "two"),
    "several with values": ("const float zero = f(1, 2), one = 2.0;\nconst float two = 0.0;\nvoid main() { one; }",
                            "one", "two"),
    "blocks of uniforms": ("uniform Block { vec4 one; };\nuniform Other { vec4 two; };\nvoid main() { one; }",
                           "one", "two"),
    "prototypes": ("float one(float x, float y);\nfloat two(float x);\nvoid main() { one(1.0, 2.0); }\n"
                   "float one(float x, float y) { return x; }\nfloat two(float x) { return x; }",
                   "one(float x, float y);", "two"),
    "functions with a precision": ("highp float one() { return 1.0; }\nfloat[2] two() { return float[2](1.0, 2.0); }\n"
                                   "void main() { one(); }", "one", "two"),
    "struct variables": ("struct S { float a; } one;\nstruct T { float a; } two;\nvoid main() { one; }", "one", "two"),
}


@pytest.mark.parametrize("case", KEPT)
def test_only_what_main_reaches_stays(case):
    text, kept, dropped = KEPT[case]
    made = put_together(text)
    declarations, mains = re.subn(r"void main\(\) \{.*?\}", "", made.text)
    assert kept in declarations and mains == 1
    assert not re.search(rf"\b{dropped}\b", declarations)


def test_reach_goes_through_functions_constants_and_structs():
    made = put_together("@a\nvoid main() { first(); }", a="""const float K = 1.0;
struct S { float x; };
S second() { return S(K); }
float first() { return second().x; }
float third() { return K; }""")
    assert made.kept == ("second", "first", "main") and made.left_out == ("third",)
    assert "struct S" in made.text and "const float K" in made.text


def test_overloads_stay_together():
    made = put_together("float f(float x) { return x; }\nfloat f(vec2 x) { return x.x; }\nvoid main() { f(1.0); }")
    assert made.kept == ("f", "main") and "f(vec2 x)" in made.text


def test_the_order_of_the_text_is_kept():
    made = put_together("@a\n@b\nvoid main() { b(); }", a="float a() { return 1.0; }", b="float b() { return a(); }")
    assert made.text.index("float a()") < made.text.index("float b()") < made.text.index("void main()")


def test_used_and_idle_files():
    made = put_together("@a\n@b\n@c\nvoid main() { a(); }\nfloat unused() { return 0.0; }",
                        a="float a() { return 1.0; }\n// the end of a\n", b="// b\nfloat b() { return 1.0; }\n",
                        c="const float C = 1.0;\n")
    assert made.files == ("glsl/a.glsl",) and made.idle == ("glsl/b.glsl", "glsl/c.glsl")
    assert made.left_out == ("b",), "only what an included file offers and nobody takes"


def test_a_file_whose_functions_are_all_left_out_is_idle():
    made = assemble('#include "core/elliptic.glsl"\nvoid main() { gl_Position = vec4(PI); }', "root")
    assert made.idle == ("glsl/core/elliptic.glsl",) and made.files == ("glsl/core/constants.glsl",)


def test_the_header_is_first_and_chosen():
    for header in (shader.DESKTOP, shader.WEB):
        made = assemble("void main() {}", "root", header=header)
        assert made.text.split("\n")[:len(header)] == list(header) and made.header == len(header)


def test_braces_that_do_not_meet_are_named():
    with pytest.raises(Problem, match=r"x\.py, line 21: a \{ that is never closed"):
        assemble("uniform float a;\nfloat f() {\n  if (a > 0.0) {\n  return a;\n}\nvoid main() { f(); }", "x.py",
                 first=20)
    with pytest.raises(Problem, match=r"x\.py, line 22: a \} that closes nothing"):
        assemble("float f() {\n  return a; }\n}\nvoid main() { f(); }", "x.py", first=20)


@given(st.lists(st.tuples(st.sampled_from("abcdefg"), st.sets(st.sampled_from("abcdefg"))), min_size=1, max_size=12))
def test_the_kept_functions_are_exactly_the_reachable_ones(graph):
    calls: dict[str, set[str]] = {}
    for name, others in graph:
        calls.setdefault(name, set()).update(others)
    text = "\n".join(f"float {n}() {{\n  return {' + '.join([f'{m}()' for m in sorted(others)] or ['1.0'])};\n}}"
                     for n, others in graph) + "\nvoid main() { a(); }"
    reached, queue = set(), ["a"]
    while queue:
        if (name := queue.pop()) in calls and name not in reached:
            reached.add(name)
            queue += calls[name]
    made = assemble(text, "root")
    assert set(made.kept) - {"main"} == reached
    assert all(text.split("\n")[line.number - 1] == line.text for line in made.lines)


# --- the way back to a person's line -------------------------------------------------------------------------------
STYLES = ["0:{0}(5): error: `x' undeclared", "ERROR: 0:{0}: 'x' : undeclared identifier",
          "0({0}) : error C1008: undefined variable \"x\"", "ERROR: 0:{0}: error(#143) Undeclared identifier: x"]


@pytest.mark.parametrize("style", STYLES)
def test_a_message_names_the_file_and_line_a_person_wrote(style):
    made = assemble('\n#include "core/constants.glsl"\nfloat unused() { return PI; }\n\nvoid main() {\n    x = PI;\n}',
                    "lessons/ch.py", first=100)
    at = made.text.split("\n").index("    x = PI;") + 1
    message = translate("GLSL Compiler failed\n\nvertex_shader\n=============\n" + style.format(at), made)
    assert message.startswith("lessons/ch.py, line 105: ") and re.search("[Uu]nde(clared|fined)", message)
    assert "=====" not in message
    in_include = made.text.split("\n").index("const float PI = 3.14159265358979;") + 1
    assert translate(style.format(in_include), made).startswith("glsl/core/constants.glsl, line 1: ")


def test_messages_come_once_and_the_end_of_the_text_counts():
    made = assemble("void main() {\n}", "x.py")
    assert translate("0:2(1): error: a\n0:2(1): error: a\n0:3(1): warning: b", made) == (
        "x.py, line 1: error: a\nx.py, line 2: warning: b")
    assert translate("0:99(1): error: unexpected end of file", made) == "x.py, line 2: error: unexpected end of file"
    assert translate("the driver gave up", made) == "the driver gave up"


# --- signatures and uniforms ---------------------------------------------------------------------------------------
def test_signatures():
    found = signatures("""
float f(float x, in vec3 n, const in int k, out highp vec2 r) { return x; }
vec3 g(vec3 corners[MAX_CORNERS],
       float[4] w) // a remark {
{
    if (w[0] > 0.0) { return corners[0]; }
else if (w[1] > 0.0) {
    return corners[1]; }
    return corners[2];
}
/* float no(float x) { } */
float later(float x);
void nothing() { }
void also_nothing(void) { }
""")
    assert list(found) == ["f", "g", "nothing", "also_nothing"]
    assert found["f"].args == (Argument("float", "x"), Argument("vec3", "n"), Argument("int", "k"),
                               Argument("vec2", "r"))
    assert found["g"].args == (Argument("vec3", "corners", "MAX_CORNERS"), Argument("float", "w", "4"))
    assert found["g"].returns == "vec3" and found["nothing"].args == found["also_nothing"].args == ()


def test_uniforms():
    text = "uniform float a;\n// uniform float no;\n  uniform highp vec3 b[13];\nuniform int c, d[2];\nfloat uniform_e;"
    assert uniforms(text) == {"a": "float", "b": "vec3", "c": "int", "d": "int"}


def test_the_catalogue_is_all_of_optics():
    defined = re.compile(r"^(?:float|int|vec\d) (\w+)\(", re.M)
    wanted = {(name, f"optics/{path.name}") for path in (GLSL / "optics").glob("*.glsl")
              for name in defined.findall(path.read_text("utf-8"))}
    assert {(name, include) for name, (include, _) in shader.catalogue().items()} == wanted
