"""Loops of a user's texts: the endless ones are left and told at their line, the others run unchanged."""

import re

import numpy as np
import pytest

from app import edit, loops, shader
from app.board import board_step
from app.board.brdf_file import parse
from app.board.brdf_model import BrdfModel
from app.catalog import step
from app.gpu.evaluate import evaluate
from app.gpu.stage import Stage
from app.gpu.watch import watch
from app.paths import GLSL
from app.problem import Problem
from app.state import defaults
from app.theme import THEMES
from tests.window import drive, until

STEP = "microfacets/cook_torrance"
N = np.array([0.0, 0.0, 1.0])
ENDLESS = {  # a loop, and the line of it that never ends
    "for without a condition": ("for (;;) ;", 1),
    "while, of a value": ("while (m > 0.0) {}", 1),
    "do": ("do {\n    m *= 1.0;\n} while (true);", 3),
    "inner": ("for (int i = 0; i < 10; i++)\n    while (i < 20) { if (i > 20) break; }", 2),
    "counts backwards": ("for (int i = 0; i < 10; i--) i = 0;", 1),
    "continues": ("int i = 0;\nwhile (i < 3) { if (m > 0.0) continue; i++; }", 2),
    "in a macro": ("#define EVER for (;;)\nEVER { m += 1e-9; }", 2),
    "in a remark's shade": ("/* for ( */ while /* ) */ ( // )\n  true ) { }", 2),
}


def with_loop(name: str, body: str) -> str:
    """The course's text of a function, its first line followed by other statements."""
    head, _, rest = edit.functions(step(STEP))[name].text.partition("{")
    return f"{head}{{\n{body}\n{rest.lstrip(chr(10))}"


def edits(text: str, name: str = "d_beckmann") -> shader.Overrides:
    found = step(STEP)
    return edit.overrides({name: text}, edit.functions(found), edit.source_of(found))


# --- the text --------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("text", "counted"), [
    ("for (int i = 0; i < 3; i++) x();", "for (int i = 0;( i < 3) && N; i++) x();"),
    ("for(;;);", "for(;N;);"),
    ("while (a, b) c;", "while ((a, b) && N) c;"),
    ("do x(); while (f(1, (2)));", "do x(); while ((f(1, (2))) && N);"),
    ("while (bool more = f(x)) x--;", "while (bool more =( f(x)) && N) x--;"),
    ("while (a[2] == b) ;", "while ((a[2] == b) && N) ;"),
    ("for (int i = 0; // ; )\n i < 3; i++) {}", "for (int i = 0;( // ; )\n i < 3) && N; i++) {}"),
    ("// while (x)\nfloat for_all; /* for (;;) */", "// while (x)\nfloat for_all; /* for (;;) */"),
    ("#define EVER for (;;)", "#define EVER for (;N;)"),
])
def test_a_loop_is_counted_in_its_condition(text, counted):
    found = loops.guarded(text, "a file")
    assert found.replace(loops.COUNT, "N") == counted and found.count("\n") == text.count("\n")


@pytest.mark.parametrize(("text", "line"), [("\n#define F for\nF (;;) ;", 12), ("while\n{ }", 11),
                                            ("#define R i < 3; i++\nfor (int i = 0; R) ;", 12), ("for (;;", 11)])
def test_a_loop_that_hides_is_refused_at_its_line(text, line):
    with pytest.raises(Problem, match=rf"^a file, line {line}: a loop is written out in one place, as (for|while) \("):
        loops.guarded(text, "a file", 11)


def test_what_glsl_counts_is_what_is_told():
    assert re.search(r"MOST_TURNS = (\d+)", (GLSL / "stage/turns.glsl").read_text("utf-8"))[1] == str(loops.MOST)


def test_the_courses_own_loops_are_not_counted(ctx):
    """But for an edited function the text of a step is the course's, also in the file that the function stands in."""
    stage = Stage(ctx, edit.source_of(step(STEP)))
    assert not stage.own.made.watched
    stage.rewrite(edits(edit.functions(step(STEP))["d_beckmann"].text + "\n"))
    assert not stage.own.made.watched and stage.source.overrides
    stage.release()


# --- a text that is typed --------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ENDLESS)
def test_an_endless_loop_is_told_and_the_picture_goes_on(ctx, name):
    found, (body, line) = step(STEP), ENDLESS[name]
    values, camera = defaults(found), found.step.scene.camera
    stage = Stage(ctx, edit.source_of(found))

    def picture() -> np.ndarray:
        stage.draw(values, camera, (96, 64), THEMES["dark"], fine=False)
        return stage.picture.pixels()

    before, drawn_by = picture(), dict(stage.programs)
    with pytest.raises(Problem) as problem:
        stage.rewrite(edits(with_loop("d_beckmann", body)), lambda: watch(stage, values, camera))
    assert edit.complaints(str(problem.value), "d_beckmann") == [(1 + line, loops.NEVER)]
    assert stage.programs == drawn_by and not stage.own.passing  # no frame waits for it
    assert np.array_equal(picture(), before)
    stage.release()


@pytest.mark.parametrize("name", ENDLESS)
def test_a_number_made_of_an_endless_loop_is_none(name):
    body, line = ENDLESS[name]
    with pytest.raises(Problem, match=rf"^your d_beckmann, line {1 + line}: this loop never ends"):
        evaluate("d_beckmann", {"n": N, "h": N, "m": 0.3}, overrides=dict(edits(with_loop("d_beckmann", body))))


@pytest.mark.parametrize("where", ["surface_point", "mark_point", "probe"])
def test_a_loop_in_the_places_of_a_scene_is_told(ctx, where):
    found = step(STEP)
    stage = Stage(ctx, edit.source_of(found))
    with pytest.raises(Problem, match=rf"^your {where}, line 2: this loop never ends"):
        stage.rewrite(edits(with_loop(where, "while (true) {}"), where),
                      lambda: watch(stage, defaults(found), found.step.scene.camera))
    stage.release()


def test_a_loop_of_a_thousand_steps_changes_nothing(ctx):
    """Of numbers, bit by bit, and of the picture; one that ends early is no fault."""
    body = "float sum = 0.0;\nfor (int i = 0; i < 1000; i++) sum += 0.25;\nm *= sum / 250.0;\nwhile (true) break;"
    found, mine = step(STEP), edits(with_loop("d_beckmann", body))
    args = {"n": N, "h": np.stack([np.sin(t := np.linspace(0, 1.5, 50)), 0 * t, np.cos(t)], -1), "m": 0.3}
    course = edits(edit.functions(found)["d_beckmann"].text + "\n")
    np.testing.assert_array_equal(*(evaluate("d_beckmann", args, overrides=dict(one)) for one in (mine, course)))
    values, camera = defaults(found), found.step.scene.camera
    stage, pictures = Stage(ctx, edit.source_of(found)), []
    for one in (course, mine):
        stage.rewrite(one, lambda: watch(stage, values, camera))
        stage.draw(values, camera, (96, 64), THEMES["dark"], fine=False)
        pictures.append(stage.picture.pixels())
    assert stage.own.made.watched and np.array_equal(*pictures)
    stage.release()


# --- a file of one's own ---------------------------------------------------------------------------------------------
FILE = """analytic
::begin parameters
float k 0 1 0.5
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    float s = 0.0;
    for (int i = 0; i < 1000; i++) s += 0.001 * k;
    while (k > 0.9) { s += 1.0; }
    return vec3(s);
}
::end shader
"""


def test_a_file_ends_at_some_values_only(tmp_path, ctx):
    model = BrdfModel(parse(FILE, "x.brdf"))
    np.testing.assert_allclose(model.rgb(N, N, N), [0.5] * 3, rtol=1e-5)
    with pytest.raises(Problem, match=r"^x\.brdf, line 9: this loop never ends"):
        model.rgb(N, N, N, {"k": 1.0})
    path = tmp_path / "x.brdf"
    path.write_text(FILE, "utf-8")
    found = board_step.step(str(path))
    stage, camera = Stage(ctx, edit.source_of(found)), found.step.scene.camera
    stage.draw(defaults(found), camera, (96, 64), THEMES["dark"])
    watch(stage, defaults(found), camera)
    with pytest.raises(Problem, match=r"x\.brdf, line 9: this loop never ends"):
        watch(stage, defaults(found) | {"model0_k": 1.0}, camera)
    while stage.settle(defaults(found), camera, THEMES["dark"]):  # every surface in a program of its own
        pass
    with pytest.raises(Problem, match=r"x\.brdf, line 9: this loop never ends"):
        watch(stage, defaults(found) | {"model0_k": 1.0}, camera)
    assert stage.scene.texts[0].text.count("while (") == 1 and loops.COUNT not in stage.scene.texts[0].text
    stage.release()


# --- the window ------------------------------------------------------------------------------------------------------
def test_the_window_tells_it_and_goes_on(tmp_path, monkeypatch):
    """Typed: the last text that ran is shown. At the values of a slider: no picture, until they are others."""
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))
    depends = with_loop("d_beckmann", "float s = m;\nwhile (s > 0.6) {}")

    def test(engine, window):
        session = window.session
        until(engine, window, lambda: window.scene.is_fine)
        session.set("m", 0.3)
        session.type("d_beckmann", with_loop("d_beckmann", "for (;;) {}"))
        window.editor.open("d_beckmann")
        until(engine, window, lambda: window.own.trouble == f"your d_beckmann, line 2: {loops.NEVER}")
        assert not session.visit.running and not window.own.no_picture
        until(engine, window, lambda: window.scene.is_fine)
        assert window.editor.widget.markers == ((2, loops.NEVER),)
        session.type("d_beckmann", depends)
        until(engine, window, lambda: session.visit.running == {"d_beckmann": depends})
        assert not window.own.trouble
        session.set("m", 0.8)
        until(engine, window, lambda: window.own.no_picture == f"your d_beckmann, line 3: {loops.NEVER}")
        session.set("m", 0.4)
        until(engine, window, lambda: not window.own.no_picture and window.scene.is_fine)

    drive(test, start=STEP)


def test_a_file_on_the_board_stops_nothing_either(tmp_path, monkeypatch):
    """At values where it never ends picture, numbers and ring have none; at others all is there again."""
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))
    path = tmp_path / "x.brdf"
    path.write_text(FILE, "utf-8")

    def test(engine, window):
        until(engine, window, lambda: window.scene.is_fine)
        window.session.set("model0_k", 1.0)
        until(engine, window, lambda: "line 9: this loop never ends" in window.own.no_picture)
        until(engine, window, lambda: window.board.peak[1] == 0.0)
        window.session.set("model0_k", 0.4)
        until(engine, window, lambda: not window.own.no_picture and window.scene.is_fine)
        until(engine, window, lambda: window.board.peak[1] > 0.0)

    drive(test, start=f"board/{path}")
