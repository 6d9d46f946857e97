"""Choices that are decided when a program is compiled: the same picture, no uniform, a compilation for each flip."""

from dataclasses import replace

import moderngl
import numpy as np
import pytest

from app import edit
from app.catalog import step, steps, values_of
from app.export.still import data
from app.export.web.content import content
from app.gpu.pick import raw
from app.gpu.scene_programs import KEPT
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.inspect_all import Row, summary
from app.inspection import inspect
from app.inspection import words as inspected
from app.lesson import Value
from app.maps import OwnMap
from app.problem import Problem
from app.pruning import decide
from app.shader import Source as Text
from app.shader import blocks_of
from app.state import defaults
from app.theme import THEMES
from app.validation import faults

DECIDED = [found for found in steps() if found.step.scene.decided]
WORK, UNITS = step("lights/area_work"), step("lights/area_units")
SIZE, DARK = (96, 72), THEMES["dark"]


def whole(found) -> dict:
    values = defaults(found)
    return values | data(found, values)


def on_stage(found, values, ctx, **changes) -> Stage:
    scene = replace(found.step.scene, **changes)
    return Stage(ctx, Source(scene, found.file_name, found.glsl_line), values.get("triangles"), values)


def picture(stage, values) -> np.ndarray:
    stage.draw(values, stage.scene.camera, SIZE, DARK, fine=False)
    assert not stage.picture.faults()
    return stage.picture.pixels().astype(int)


@pytest.fixture
def compiled(monkeypatch, ctx) -> list[str]:
    """The texts that are handed to OpenGL from now on; nothing is taken from earlier."""
    texts: list[str] = []
    real = moderngl.Context.program

    def watched(self, *, vertex_shader, fragment_shader=None, **more):
        texts.append(vertex_shader + (fragment_shader or ""))
        return real(self, vertex_shader=vertex_shader, fragment_shader=fragment_shader, **more)

    monkeypatch.setattr(moderngl.Context, "program", watched)
    monkeypatch.setattr(ctx, "extra", {})
    return texts


def test_some_steps_decide():
    assert {"lights/area_sampled", "lights/area_work", "plausible_shading/board"} <= {found.id for found in DECIDED}


@pytest.mark.parametrize("found", DECIDED, ids=lambda found: found.id)
def test_the_picture_is_the_same_for_every_choice(found, ctx):
    values = whole(found)
    asked, ready = on_stage(found, values, ctx, decided=()), on_stage(found, values, ctx)
    seen = []
    for name in found.step.scene.decided:
        for number in range(len(found.values[name].choices) if name in found.values else 0):
            now = values | {name: number}
            seen.append(picture(ready, now))
            assert np.abs(seen[-1] - picture(asked, now)).max() <= 1, (name, number)
            assert np.allclose(ready.probes(now), asked.probes(now), atol=1e-5)
    for table in found.step.scene.tables:
        texels = np.random.default_rng(3).integers(100, 256, (8, 8, 4)).astype(np.uint8)
        texels[..., 3] = 255
        now = values | {table.uniform: OwnMap(table.map, "my own", texels, "").texels}
        seen.append(picture(ready, now))
        assert np.abs(seen[-1] - picture(asked, now)).max() <= 1, table.map
        assert np.abs(seen[-1] - picture(ready, values)).max() > 20, "the map is seen"
    assert max(np.abs(one - seen[0]).max() for one in seen[1:]) > 20, "a choice is seen"
    asked.release()
    ready.release()


def test_a_flip_compiles_what_has_changed_and_its_way_back_nothing(ctx, compiled):
    values = whole(WORK)
    stage = on_stage(WORK, values, ctx)
    first = len(compiled)
    picture(stage, values)
    assert len(compiled) == first == len(stage.programs), "its programs, and each once"
    for name in ("light_shape", "sampling"):
        assert not any(f"uniform int {name};" in text for text in compiled)
    assert sum("const int sampling = 2;" in text for text in compiled) == 2, "the floor's and the dots'"
    flipped = values | {"sampling": 5}
    picture(stage, flipped)
    assert len(compiled) == first + 2
    for now in (values, flipped, values | {"level": 3}):
        picture(stage, now)
    assert len(compiled) == first + 2
    stage.release()


def test_few_choices_are_kept_and_others_released(ctx, compiled):
    values = whole(UNITS)
    stage = on_stage(UNITS, values, ctx)
    scene_programs = dict(stage.programs)
    for number in (1, 2, 3, 0, 1, 2, 3):
        picture(stage, values | {"light_shape": number})
    assert len(stage.own.others) == 3 <= KEPT
    own = list(stage.own.passing.values())
    stage.own.others.clear()
    stage.own.let_go()
    assert sum(type(use.mglo).__name__ == "InvalidObject" for use in own) > 3
    assert picture(stage, values).std() > 5 and dict(stage.programs) == scene_programs
    stage.release()


def test_the_values_of_the_first_picture_are_decided_at_once(ctx, compiled):
    values = whole(WORK) | {"sampling": 4, "light_shape": 3}
    stage = on_stage(WORK, values, ctx)
    first = len(compiled)
    picture(stage, values)
    assert len(compiled) == first and any("const int sampling = 4;" in text for text in compiled)
    stage.release()


def test_a_text_that_is_edited_is_right_for_every_choice(ctx, compiled):
    known, source, values = edit.functions(WORK), edit.source_of(WORK), whole(WORK)
    stage = Stage(ctx, source, None, values)
    text = known["sample_share"].text.replace("to_sample.z /", "2.0 * to_sample.z /")
    before = picture(stage, values)
    stage.rewrite(edit.overrides({"sample_share": text}, known, source))
    edited = picture(stage, values)
    assert np.abs(edited - before).max() > 20
    plain, now = on_stage(WORK, values, ctx, decided=()), values | {"light_shape": 1}
    plain.rewrite(edit.overrides({"sample_share": text}, known, source))
    assert np.abs(picture(stage, now) - edited).max() > 20
    assert np.abs(picture(stage, now) - picture(plain, now)).max() <= 1
    stage.rewrite(())
    plain.rewrite(())
    assert np.abs(picture(stage, now) - picture(plain, now)).max() <= 1
    stage.release()
    plain.release()


def test_a_mistake_is_told_where_it_is_not_chosen_now_too(ctx):
    known, source, values = edit.functions(WORK), edit.source_of(WORK), whole(WORK)
    stage = Stage(ctx, source, None, values)
    text = known["shade"].text.replace("{", "{ if (light_shape == 3) return vec3(mistaken);", 1)
    with pytest.raises(Problem, match=r"^your shade, line 1: .*mistaken"):
        stage.rewrite(edit.overrides({"shade": text}, known, source))
    stage.release()


def test_an_edit_compiles_what_holds_it_and_no_more(ctx, compiled):
    """Of one kind of surface no more than one program, and nothing that does not hold the text."""
    for found, name in ((WORK, "sample_share"), (step("plausible_shading/everything"), "d_beckmann"),
                        (step("microfacets/cook_torrance"), "d_beckmann")):
        known, source, values = edit.functions(found), edit.source_of(found), whole(found)
        stage = Stage(ctx, source, values.get("triangles"), values)
        picture(stage, values)
        stage.rewrite(edit.overrides({name: known[name].text.replace("{", "{ float first = 0.0;", 1)}, known, source))
        del compiled[:]
        stage.rewrite(edit.overrides({name: known[name].text.replace("{", "{ float second = 0.0;", 1)}, known, source))
        assert 1 <= len(compiled) <= 3 and all("float second" in text for text in compiled)
        stage.release()


def test_a_picked_pixel_follows_a_choice(ctx):
    board = step("plausible_shading/board")
    values = whole(board)
    stage, plain = on_stage(board, values, ctx), on_stage(board, values, ctx, decided=())
    camera = board.step.scene.camera
    for number in (0, 6):
        ours, theirs = (raw(one, values | {"shows": number}, camera, DARK, (24, 18)) for one in (stage, plain))
        for a, b in zip(ours, theirs, strict=True):
            assert np.allclose(a, b, atol=1e-4)
    stage.release()
    plain.release()


@pytest.mark.parametrize(("decided", "sentence"), [
    ("no_such", "the scene decides no_such, which is no choice"),
    ("panel_width", "the scene decides panel_width, which is no choice"),
    ("level", "the scene decides level, which is no choice"),
    ("shape", "its GLSL has no line `uniform int shape;`"),
])
def test_what_cannot_be_decided_is_refused(decided, sentence):
    scene = replace(WORK.step.scene, decided=(decided,))
    more = (Value("shape", 0, choices=("this", "that")),) if decided == "shape" else ()
    wrong = replace(WORK, step=replace(WORK.step, scene=scene, values=(*WORK.step.values, *more)))
    with pytest.raises(Problem, match=sentence.replace(".", r"\.")):
        values_of(wrong.step)
    assert any(sentence in said for _, said in faults(wrong))


def test_a_page_is_told_what_is_decided():
    scene = content(WORK)["scene"]
    assert scene["decided"] == ["light_shape", "sampling"]
    lines = {line for pair in scene["programs"].values() for text in pair for line in text.split("\n")}
    assert {"uniform int light_shape;", "uniform int sampling;"} <= lines
    plate = content(step("plausible_shading/texturing"))["scene"]
    text = "".join(part for pair in plate["programs"].values() for part in pair)
    assert plate["decided"] == [] and "own_albedo;" not in text and "albedo_map" not in text, "a page has no maps"


def test_inspect_tells_what_is_decided_and_compiled():
    found = inspect(WORK, defaults(WORK) | {"light_shape": 1})
    assert found.decided == {"light_shape": "disk", "sampling": "stratified"}
    assert "irradiance_disk_light" in found.functions and "irradiance_outline" in found.functions_left_out
    assert not {"light_shape", "sampling"} & set(found.uniforms) and found.faults == ()
    assert "decided     light_shape = disk, sampling = stratified" in inspected(found)


def test_inspect_of_all_says_which_steps_decide():
    rows = [Row(inspect(found), {"ratio": 0.5}, ()) for found in (WORK, step("solid_angle/cone"))]
    told = "\n".join(summary(rows, 2))
    assert "measured so: lights/area_work (light_shape, sampling)." in told and "0 faults" not in told


# --- the text --------------------------------------------------------------------------------------------------------
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
])
def test_a_variable_that_is_set_once_is_known(code, is_known):
    text = ("uniform int kind;\nconst int THREE = 3;\nvoid sets(inout int what) { what = 7; }\n"
            f"void main() {{ {code} }}")
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


def test_a_parameter_that_is_set_is_unknown():
    text = "uniform int kind;\nfloat f(int k) { k = 2; return k == 1 ? a() : b(); }\nvoid main() { x = f(kind); }"
    assert "? a() : b()" in shortened(text, kind=1)


def test_what_a_macro_calls_is_left_alone():
    text = ("uniform int kind;\n#define CALL f(3)\nfloat f(int kind) { return kind == 1 ? a() : b(); }\n"
            "float h() { return f(kind) + CALL; }")
    assert "a() : b()" in shortened(text, kind=1)


def test_a_surface_knows_its_number_unless_another_is_made():
    text = "vec3 shade(Surface s) { return s.id == 1 ? a() : b(); }\nvoid main() { x = shade(Surface(surface, y)); }"
    assert "b()" not in shortened(text, surface=1)
    assert "b()" in shortened(text.replace("Surface(surface, y)", "Surface(2, y)"), surface=1)
    assert "b()" in shortened(text.replace("{ return", "{ s.id = 3; return"), surface=1)


def test_a_surfaces_program_has_only_what_it_is_coloured_by():
    """The scales of a floor need nothing of its light."""
    known = {"light_shape": 0, "sampling": 2}
    floor, scale = (programs(WORK.step.scene, names=("surface",), known=known | {"surface": i})["surface"][1]
                    for i in (0, 1))
    assert "irradiance_light_sampled" in floor.kept and "irradiance_light_sampled" in scale.left_out
    assert len(scale.text) < 0.25 * len(floor.text)
