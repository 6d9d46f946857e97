"""Text without what is not run: what is known, where it is carried, and that every picture stays what it was."""

import moderngl
import numpy as np
import pytest

from app.catalog import step, steps
from app.export.still import data
from app.gpu.context import pixel
from app.gpu.scene_programs import ScenePrograms
from app.gpu.scene_texts import SceneTexts
from app.gpu.stage import Stage
from app.gpu.stage_text import Programs, Source
from app.gpu.uniforms import give
from app.pruning import decide
from app.shader import Source as Text
from app.shader import blocks_of
from app.state import defaults
from app.theme import THEMES
from tests.random_glsl import KNOWN, Writer


def shortened(text: str, **known: int | frozenset[int]) -> str:
    """The code that is left, in one line, its blanks squeezed."""
    made = decide(list(blocks_of(Text(text, "test"))), known)
    assert sum(len(part.lines) for part in made) == text.count("\n") + 1, "lines keep their numbers"
    return " ".join(" ".join(line.text for part in made for line in part.lines).split())


HEAD = "uniform int kind;\nfloat f() {\n"


@pytest.mark.parametrize(("code", "kind", "left"), [
    ("if (kind == 1) return 1.0;\nreturn 2.0;\n}", 1, "return 1.0; }"),
    ("if (kind == 1) return 1.0;\nreturn 2.0;\n}", 0, "; return 2.0; }"),
    ("if (kind == 1) return 1.0;\nelse return g();\n}", 1, "return 1.0; }"),
    ("if (kind == 1) { a(); } else if (kind == 2) { b(); } else { c(); }\nd();\n}", 2, "{ b(); } d(); }"),
    ("if (kind > 0 && x > 1.0) return 1.0;\nreturn 2.0;\n}", 0, "; return 2.0; }"),
    ("if (kind > 0 && x > 1.0) return 1.0;\nreturn 2.0;\n}", 1, "if (kind > 0 && x > 1.0) return 1.0; return 2.0; }"),
    ("if (kind % 3 != 0 || x > 1.0) a();\nb();\n}", 1, "a(); b(); }"),
    ("return kind == 0 ? g(1.0) : kind == 1 ? h(2.0) : i(3.0);\n}", 1, "return h(2.0) ; }"),
    ("return x > 0.0 ? kind == 1 ? a : b : c;\n}", 0, "return x > 0.0 ? b : c; }"),
    ("float t = kind == 1 ? 0.0 : tilt, c = cos(t);\nreturn t;\n}", 0, "float t = tilt, c = cos(t); return t; }"),
    ("for (int i = 0; i < (kind == 2 ? 8 : 0); i++) { if (kind == 2) continue; a(); }\nb();\n}", 2,
     "for (int i = 0; i < ( 8 ); i++) { continue; } b(); }"),
    ("if (!(kind == 1)) a(); // kind == 1\nb();\n}", 1, "; // kind == 1 b(); }"),
    ("if (kind == 1.0) a();\nb();\n}", 1, "if (kind == 1.0) a(); b(); }"),
    ("int kind = 3;\nif (kind == 1) a();\nb();\n}", 1, "int kind = 3; if (kind == 1) a(); b(); }"),
    ("if (s.kind == 1) a();\nb();\n}", 1, "if (s.kind == 1) a(); b(); }"),
])
def test_a_decided_branch_goes(code, kind, left):
    assert shortened(HEAD + code, kind=kind) == f"const int kind = {kind}; float f() {{ {left}"


@pytest.mark.parametrize("body", [
    "return kind % 0 == 1 ? 1.0 : 2.0;", "return kind == 010 ? 1.0 : 2.0;", "return (kind == 1)(2) ? 1.0 : 2.0;",
    "if (kind == 1", "if (kind == 1) ", "return kind == 1 ? 1.0 ;", "float x = kind == 1 ? ;",
    "if (kind > 0) {" * 2000 + "}" * 2000, "return (" * 3000 + "kind == 1" + ")" * 3000 + " ? 1.0 : 2.0;",
])
def test_what_is_no_glsl_or_too_deep_is_left_to_the_compiler(body):
    assert "kind" in shortened(f"{HEAD}{body}\n}}", kind=1)


def test_brackets_in_a_condition_are_no_hindrance():
    assert shortened(HEAD + "if (!(kind == 1 && kind < 3)) a();\nb();\n}", kind=1).endswith("; b(); }")


@pytest.mark.parametrize(("calls", "left"), [
    ("f(kind)", "a()"), ("f(kind) + g(kind)", "a()"), ("f(2)", "b()"), ("f(kind + 1)", "b()"), ("f(kind) + f(2)", "?"),
    ("g(3)", "b()"), ("f(3) + g(2)", "b()"), ("f(unknown)", "?"), ("f(g(1) > 0.0 ? 1 : 2)", "?"),
])
def test_a_parameter_is_known_by_all_calls_that_are_run(calls, left):
    text = ("uniform int kind;\nfloat f(int which) { return which == 1 ? a() : b(); }\n"
            "float g(int kind) { return f(kind); }\nfloat never() { return f(1) + f(2); }\n"
            f"void main() {{ x = {calls}; }}")
    body = shortened(text, kind=1).partition("{ return")[2].partition("}")[0]
    assert left == ("?" if "?" in body else body.strip(" ;"))


def test_a_call_that_is_not_run_tells_nothing():
    text = ("uniform int kind;\nfloat f(int which) { return which == 1 ? a() : b(); }\n"
            "float g() { if (kind == 2) return f(2); return f(1); }\nvoid main() { x = g(); }")
    assert "b()" not in shortened(text, kind=1) and "b()" in shortened(text, kind=2)


@pytest.mark.parametrize(("code", "is_known"), [
    ("int at = kind % 3, of = kind / 3; if (at == 1 && of == 1) a(); else b();", True),
    ("const bool is = kind == 4; if (is) a(); else b();", True),
    ("int at = THREE + 1; if (at == kind) a(); else b();", True),
    ("int at = kind; at = 2; if (at == 4) a(); else b();", False),
    ("int at = kind; if (x > 1.0) at += 1; if (at == 4) a(); else b();", False),
    ("int at = kind; sets(at); if (at == 4) a(); else b();", False),
    ("int at = kind; y = frexp(x, at); if (at == 4) a(); else b();", False),
    ("for (int at = kind; at < 9; at++) { if (at == 4) a(); else b(); }", False),
    ("{ int at = kind; } { int at = 3; if (at == 4) a(); else b(); }", False),
    ("int at; if (at == 4) a(); else b();", False),
    ("int at = kind - 9; if (at / 2 == -2) a(); else b();", False),
    ("int at = unknown; if (at == 4) a(); else b();", False),
    ("int THREE = 5; if (THREE == 5) a(); else b();", False),
    ("{ int width = 2; } if (width > 1) a(); else b();", False),  # GLSL takes 1 as 1.0 there
    ("int other, kind; kind = f(); if (kind == 4) a(); else b();", False),
    ("int SOME = 3; if (SOME == 3) a(); else b();", False),  # it may stand for anything
    ("if (CHOSEN == 2) a(); else b();", False),  # one of two is compiled
])
def test_a_variable_that_is_set_once_is_known(code, is_known):
    text = ("uniform int kind;\nuniform float width;\n#define SOME kind\nconst int THREE = 3;\n"
            "#ifdef NO\nconst int CHOSEN = 2;\n#else\nconst int CHOSEN = 3;\n#endif\n"
            f"void sets(inout int what) {{ what = 7; }}\nvoid main() {{ {code} }}")
    made = shortened(text, kind=4)
    assert "a();" in made and ("b();" not in made) == is_known


@pytest.mark.parametrize(("condition", "left"), [
    ("surface == 4", "b();"), ("surface % 3 == 0", "a();"), ("surface / 3 == 1", "if"), ("surface < 7", "a();"),
    ("surface == 3 || surface == 6 || surface == 0", "a();"), ("surface == 0 && x > 1.0", "if"),
    ("surface == 4 && x > 1.0", "b();"),
])
def test_of_some_surfaces_what_holds_for_all_is_decided(condition, left):
    text = f"uniform int surface;\nvoid main() {{ if ({condition}) a(); else b(); }}"
    made = shortened(text, surface=frozenset((0, 3, 6)))
    assert made.startswith("uniform int surface;")
    assert ("if (" in made) == (left == "if") and left in made


@pytest.mark.parametrize("sets", ["k = 2;", "k++;", "--k;", "other(k);", "if (x > 1.0) k -= 1;"])
def test_a_parameter_that_is_set_is_unknown(sets):
    text = ("uniform int kind;\nvoid other(out int what) { what = 2; }\n"
            f"float f(int k) {{ {sets} return k == 1 ? a() : b(); }}\nvoid main() {{ x = f(kind); }}")
    assert "? a() : b()" in shortened(text, kind=1)


def test_of_functions_of_one_name_what_all_calls_give_is_known():
    text = ("uniform int kind;\nfloat f(int k) { return k == 1 ? a() : b(); }\n"
            "float f(float k, int j) { return j == 1 ? c() : d(); }\nfloat f(float j) { return e(); }\n"
            "void main() { x = f(kind) + f(2.0); }")
    assert "? a() : b()" in shortened(text, kind=1)
    assert "? a() : b()" in shortened(text.replace("f(2.0)", "f(2.0, kind)"), kind=1)


@pytest.mark.parametrize("macro", ["f(3)", "g()"])
def test_what_a_macro_calls_is_left_alone(macro):
    """Itself, and through a function that nothing else leads to."""
    text = (f"uniform int kind;\n#define CALL {macro}\nfloat f(int k) {{ return k == 1 ? a() : b(); }}\n"
            "float g() { return f(3); }\nvoid main() { x = f(kind) + CALL; }")
    assert "a() : b()" in shortened(text, kind=1)
    assert "b()" not in shortened(text.replace(" + CALL", "").replace("#define", "// "), kind=1)


def test_what_a_macro_stands_for_is_unknown():
    text = "uniform int kind;\nfloat f() { return kind == 1 ? a() : b(); }"
    assert "b()" not in shortened(text, kind=1) and "a() : b()" in shortened(f"#define kind 2\n{text}", kind=1)


def test_a_surface_knows_its_number_unless_another_is_made():
    text = "vec3 shade(Surface s) { return s.id == 1 ? a() : b(); }\nvoid main() { x = shade(Surface(surface, y)); }"
    assert "b()" not in shortened(text, surface=1)
    assert "b()" in shortened(text.replace("Surface(surface, y)", "Surface(2, y)"), surface=1)
    assert "b()" in shortened(text.replace("{ return", "{ s.id = 3; return"), surface=1)


# --- pictures --------------------------------------------------------------------------------------------------------
class WholeTexts(SceneTexts):
    """Nothing is known, and so nothing is left out."""

    def programs(self, names, known=None, plain=False) -> Programs:
        return super().programs(names, None, plain)


class Whole(ScenePrograms):
    kind_of_texts = WholeTexts
    one_program = True


class WholeStage(Stage):
    kind = Whole


BOARDS = [step("board/cook_torrance"), step("board/phong+lambert+cook_torrance")]


@pytest.mark.parametrize("found", [*steps(), *BOARDS], ids=lambda found: found.id)
def test_every_picture_and_point_is_that_of_the_whole_text(found, ctx):
    values, scene = defaults(found), found.step.scene
    values |= found.derived(values)
    values |= data(found, values)
    source, pictures = Source(scene, found.file_name, found.glsl_line), []
    for kind in (Stage, WholeStage):
        stage = kind(ctx, source, values.get("triangles"), values)
        stage.draw(values, scene.camera, (96, 72), THEMES["dark"], fine=False)
        pictures.append((stage.picture.pixels().astype(int), stage.probes(values), stage.anchors(values)))
        stage.release()
    (ours, probes, anchors), (whole, whole_probes, whole_anchors) = pictures
    off = np.abs(ours - whole).max(-1)
    assert (off > 1).mean() < 2e-3 and off.std() < 1.0, "but for a pixel on an edge"
    assert np.allclose(probes, whole_probes, atol=1e-5)
    assert anchors.keys() == whole_anchors.keys() and all(np.allclose(anchors[one], whole_anchors[one], atol=1e-5)
                                                          for one in anchors)


# --- at random -------------------------------------------------------------------------------------------------------
def values_of(ctx, text: str, known: dict[str, int]) -> np.ndarray:
    use = ctx.program(vertex_shader=f"#version 330 core\n{text}", varyings=("value",))
    give(use, **known)
    places = [(ctx.buffer(np.array([0.0, 1.5, 3.0], "f4")), "1f", "place")] if "place" in use else []
    array, out = ctx.vertex_array(use, places), ctx.buffer(reserve=12)
    pixel(ctx).use()
    array.transform(out, moderngl.POINTS, 3)
    found = np.frombuffer(out.read(), "f4")
    for one in (array, out, *(place[0] for place in places), use):
        one.release()
    return found


@pytest.mark.parametrize("seed", range(6))
def test_a_random_program_computes_the_same_without_what_is_not_run(seed, ctx):
    random, shorter = np.random.default_rng(seed), 0
    for i in range(20):
        text = Writer(1000 * seed + i).program()
        known = {name: int(random.integers(0, 5)) for name in KNOWN}
        several = frozenset((known["surface"], *random.integers(0, 7, 2).tolist()))
        told = known | ({"surface": several} if i % 2 else {})
        blocks = decide(list(blocks_of(Text(text, "random"))), told)
        made = "\n".join(line.text for part in blocks for line in part.lines)
        np.testing.assert_allclose(values_of(ctx, made, known), values_of(ctx, text, known), rtol=1e-5, err_msg=text)
        shorter += len("".join(made.split())) < 0.9 * len("".join(text.split()))
    assert shorter >= 5
