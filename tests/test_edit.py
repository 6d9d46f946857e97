"""GLSL edited live: what may be edited, what a text changes, what is said of a wrong one, what is kept. No window."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app import badges, edit, own_models, shader
from app.board.models import opened
from app.catalog import step, steps
from app.edit import EDITED
from app.gpu.context import program
from app.gpu.stage import Stage
from app.gpu.stage_text import typed_alone
from app.optics import twin
from app.plots.sweep import Sweep
from app.problem import Problem, Usage
from app.progress import Progress
from app.prose import links
from app.readouts import numbers
from app.session import Session
from app.state import defaults
from app.terms import evaluate
from app.theme import THEMES

STEP = "microfacets/cook_torrance"
TWICE = "slope_squared(n, h), m", "slope_squared(n, h), 2.0 * m"


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


def changed(name: str, *change: str, id: str = STEP) -> tuple:
    """A step, its values with one function's text changed, and the text."""
    found = step(id)
    known = edit.functions(found)
    assert change[0] in known[name].text
    text = known[name].text.replace(*change)
    return found, {**defaults(found), **edit.among_values({name: text}, known, edit.source_of(found))}, text


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_what_may_be_edited_stands_in_its_file(found):
    from app.paths import GLSL

    known, source = edit.functions(found), edit.source_of(found)
    assert known
    for one in known.values():
        text = source.scene.glsl if one.include == edit.SCENE else (GLSL / one.include).read_text("utf-8")
        at = one.first - (source.first if one.include == edit.SCENE else 1)
        assert text.split("\n")[at:at + one.text.count("\n") + 1] == one.text.split("\n")
        edit.check(one.text, one)  # the course's own text is right


@pytest.mark.parametrize("found", [s for s in steps() if "(code:" in s.step.prose], ids=lambda found: found.id)
def test_a_link_leads_to_a_function_that_the_step_compiles(found):
    targets = [link.target for link in links(found.step.prose) if link.target.startswith(edit.CODE)]
    named = [target.removeprefix(edit.CODE) for target in targets]
    assert named and set(named) <= set(edit.functions(found))


def test_d_g_and_f_lead_to_their_lines():
    assert {"d_beckmann", "g_vgroove", "f_schlick"} <= set(edit.spoken_of(step(STEP)))
    assert sum("(code:" in found.step.prose for found in steps() if found.loaded.number >= 4) >= 15


# --- a text runs -----------------------------------------------------------------------------------------------------
def test_numbers_follow_the_text_and_say_whose_they_are():
    found, values, _ = changed("d_beckmann", *TWICE)
    now = {n.label: n for n in numbers(found.step, values)}
    rougher = {**defaults(found), "m": 2 * values["m"]}
    expected = {n.label: n for n in numbers(found.step, rougher)}  # G and F know nothing of m
    for label, number in now.items():
        assert number.whose == ("the course's" if "albedo" in label else "yours")  # albedos are sums of their own
        if number.whose == "yours":
            assert math.isclose(number.value, expected[label].value, rel_tol=1e-5)
            assert "float32" in number.full_text
    assert all(not n.whose for n in numbers(found.step, defaults(found)))


def test_a_text_that_is_the_courses_in_other_words_gives_its_numbers():
    found, values, _ = changed("f_schlick", "x2 * x2 * x", "pow(x, 5.0)")
    for readout in found.step.readouts:
        course, mine = (float(evaluate(readout.term, v)) for v in (defaults(found), values))
        assert math.isclose(mine, course, rel_tol=1e-5)


def test_badges_and_curves_follow():
    found, values, _ = changed("brdf_cook_torrance", "return ", "return 2.0 * ")
    model = found.step.models[0]
    mine, course = (badges.of_model(model, v) for v in (values, defaults(found)))
    assert course["energy"].ok and not mine["energy"].ok
    assert math.isclose(mine["energy"].worst, 2 * course["energy"].worst, rel_tol=2e-3)
    assert badges.key(model, values) != badges.key(model, defaults(found))
    found, values, _ = changed("d_beckmann", "? ", "? 3.0 * ", id="microfacets/beckmann")
    plot = next(p for p in found.step.plots if any(edit.follows(c.term.function, values[EDITED]) for c in p.curves))
    ranges = {name: (spec.low, spec.high) for name, spec in found.values.items()}
    label = next(c.label for c in plot.curves if edit.follows(c.term.function, values[EDITED]))
    assert f"{label}, yours" in [c.label for c in edit.marked(plot, values[EDITED]).curves]
    assert edit.marked(plot, ()) == plot
    plain = type(plot)(**{**vars(plot), "error": False})
    mine, course = (next(c for c in Sweep(plain, ranges).run(v) if c.curve.label == label)
                    for v in (values, defaults(found)))
    np.testing.assert_allclose(mine.y, 3 * course.y, rtol=1e-3)


def test_the_picture_follows_and_the_last_good_one_stays(ctx):
    found, values, text = changed("d_beckmann", *TWICE)
    known, source = edit.functions(found), edit.source_of(found)
    stage, camera = Stage(ctx, source), found.step.scene.camera

    def picture() -> np.ndarray:
        stage.draw(values, camera, (160, 120), THEMES["dark"], counted=False)
        return stage.picture.pixels().astype(int)

    first = picture()
    stage.rewrite(edit.overrides({"d_beckmann": text}, known, source))
    second = picture()
    assert np.abs(second - first).max() > 30
    with pytest.raises(Problem) as problem:
        stage.rewrite(edit.overrides({"d_beckmann": text.replace("dot(", "dott(")}, known, source))
    line = next(i for i, part in enumerate(text.split("\n"), 1) if "dot(n" in part)
    assert edit.complaints(str(problem.value), "d_beckmann")[0][0] == line
    assert "dott" in edit.first_complaint(str(problem.value), "d_beckmann")
    assert np.array_equal(picture(), second)
    stage.rewrite(())
    assert np.array_equal(picture(), first)
    assert not stage.own.passing  # what was edited is released
    stage.release()


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_every_function_of_a_step_may_be_typed(found, ctx):
    """The course's own text of it compiles where one that is typed has to: a formula's in its file, without a scene."""
    known, source, made = edit.functions(found), edit.source_of(found), {}
    for name, function in known.items():
        typed = replace(source, overrides=edit.overrides({name: f"{function.text}\n"}, known, source))
        (pair,) = typed_alone(typed)
        assert any(name in part.kept for part in pair)
        program(ctx, *pair, (), made)
    for use in made.values():
        use.release()


def test_a_formula_that_only_a_scene_can_run_is_refused(ctx):
    """Numbers and plots are made of it too, and there is no eye."""
    found, known = step(STEP), edit.functions(step(STEP))
    text = known["d_beckmann"].text.replace("{", "{ m *= length(camera_position);", 1)
    stage = Stage(ctx, edit.source_of(found))
    with pytest.raises(Problem, match=r"^your d_beckmann, line 1: .*camera_position"):
        stage.rewrite(edit.overrides({"d_beckmann": text}, known, edit.source_of(found)))
    own = known["shade"].text.replace("{", "{ float far = length(camera_position);", 1)
    stage.rewrite(edit.overrides({"shade": own}, known, edit.source_of(found)))
    stage.release()


def test_a_scenes_own_function_changes_no_number():
    found, values, _ = changed("surface_point", "{", "{ ")
    assert values[EDITED] == () and {n.whose for n in numbers(found.step, values)} == {"the course's"}


# --- a text is wrong -------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("change", "sentence"), [
    (("}", ""), "your d_beckmann, line 1: a { that is never closed."),
    (("}", "}\n}"), "your d_beckmann, line 5: a } that closes nothing."),
    (("d_beckmann(vec3", "d_mine(vec3"), "your d_beckmann, line 1: d_beckmann is not defined any more; it is "
                                         "float d_beckmann(vec3 n, vec3 h, float m)."),
    (("vec3 n, vec3 h", "vec3 n"), "your d_beckmann, line 1: others call float d_beckmann(vec3 n, vec3 h, float m); "
                                   "its types must stay."),
    (("{", "{ /*"), "your d_beckmann, line 1: a remark that is never closed."),
    (("float d_beckmann(", "uniform float mine;\nfloat d_beckmann("),
     "your d_beckmann, line 1: a uniform of one's own; nothing would set it."),
])
def test_what_is_wrong_is_said_at_the_users_line(change, sentence):
    function = edit.functions(step(STEP))["d_beckmann"]
    with pytest.raises(Problem) as problem:
        edit.check(function.text.replace(*change), function)
    assert str(problem.value) == sentence


def test_other_lines_of_the_file_keep_their_numbers():
    known, source = edit.functions(step(STEP)), edit.source_of(step(STEP))
    for text in (known["slope_squared"].text.replace("{", "{\n\n\n", 1), "float slope_squared(vec3 n, vec3 h);"):
        edits = edit.overrides({"slope_squared": text}, known, source)
        lines = shader.resolve('#include "optics/beckmann.glsl"', "test", overrides=dict(edits))
        after = next(line for line in lines if line.text.startswith("float d_beckmann("))
        assert (after.file, after.number) == (known["d_beckmann"].file, known["d_beckmann"].first)
        mine = [line.number for line in lines if line.file == "your slope_squared"]
        assert mine == list(range(1, text.count("\n") + 2))


def test_an_include_in_a_remark_is_no_end_of_the_window(ctx):
    found, known = step(STEP), edit.functions(step(STEP))
    text = known["d_beckmann"].text.replace("//", '// #include "x"')
    edits = edit.overrides({"d_beckmann": text}, known, edit.source_of(found))
    with pytest.raises(Problem, match=r"^your d_beckmann, line 2: an #include stands on a line of its own\.$"):
        Stage(ctx, edit.source_of(found)).rewrite(edits)


def test_a_function_that_calls_itself_is_named(ctx):
    found, known = step(STEP), edit.functions(step(STEP))
    text = known["d_beckmann"].text.replace("return ", "return d_beckmann(n, h, m) + ", 1)
    edits = edit.overrides({"d_beckmann": text}, known, edit.source_of(found))
    with pytest.raises(Problem, match=r"^your d_beckmann, line 1: d_beckmann calls itself, which GLSL"):
        Stage(ctx, edit.source_of(found)).rewrite(edits)


# --- a text is kept --------------------------------------------------------------------------------------------------
def test_what_is_typed_is_kept_across_steps_and_exits(tmp_path):
    session = Session(STEP, Progress())
    course = session.text("d_beckmann")
    session.type("d_beckmann", "float half a sentence")
    session.next()
    session.previous()
    assert session.text("d_beckmann") == "float half a sentence" and not session.visit.running
    session.save()
    again = Session(STEP, Progress())
    assert again.text("d_beckmann") == "float half a sentence"
    again.restore("d_beckmann")
    assert again.text("d_beckmann") == course and not again.visit.texts
    again.save()
    third = Session(STEP, Progress())
    assert third.text("d_beckmann") == course
    third.bring_back("d_beckmann")
    assert third.text("d_beckmann") == "float half a sentence"


def test_a_text_under_a_name_is_a_model_of_the_board():
    found, values, text = changed("d_beckmann", *TWICE)
    path = own_models.save("my_model", found, {"d_beckmann": text}, values)
    assert path.suffix == ".brdf" and path.parent == own_models.folder()
    model = opened("my_model")
    assert [p.name for p in model.parameters] == ["m", "f0"] and model.parameters[0].default == values["m"]
    l, v = (np.array([math.sin(a), 0.0, math.cos(a)]) for a in (0.5, -0.9))
    expected = twin("brdf_cook_torrance")(np.array([0.0, 0.0, 1.0]), l, v, 2 * values["m"], values["f0"])
    np.testing.assert_allclose(model.rgb(np.array([0.0, 0.0, 1.0]), l, v), [expected] * 3, rtol=1e-4)
    assert [(one.name, one.step, one.texts) for one in own_models.saved()] == [
        ("my_model", STEP, {"d_beckmann": text})]
    with pytest.raises(Usage, match="take another name"):
        own_models.save("my_model", step("microfacets/facets"), {"is_lit": ""}, {})


def test_what_is_no_reflectance_is_kept_as_it_is():
    found, values, text = changed("is_lit", "{", "{ ", id="microfacets/facets")
    path = own_models.save("mine", found, {"is_lit": text}, values)
    assert path.suffix == ".glsl" and text in path.read_text("utf-8")
    with pytest.raises(Usage, match="a text for the editor"):
        opened("mine")
    with pytest.raises(Usage, match="is no name"):
        own_models.save("../x", found, {"is_lit": text}, values)


# --- the board -------------------------------------------------------------------------------------------------------
FILE = """analytic
::begin parameters
float k 0 1 0.5
::end parameters
::begin shader
float half_of(float x) {
    return 0.5 * x;
}

vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    return vec3(half_of(k));
}
::end shader
"""


def test_models_of_the_board_follow_and_are_saved(tmp_path):
    file = tmp_path / "plain.brdf"
    file.write_text(FILE, "utf-8")
    found = step(f"board/cook_torrance+{file}")
    known, source, plain = edit.functions(found), edit.source_of(found), defaults(found)
    mine = next(name for name in known if name.endswith("half_of"))
    texts = {mine: known[mine].text.replace("0.5", "0.25"),
             "d_beckmann": known["d_beckmann"].text.replace(*TWICE)}
    plain |= found.derived(plain)
    values = {**plain, **edit.among_values(texts, known, source)}
    (rough, of_file), (_, before) = numbers(found.step, values), numbers(found.step, plain)
    assert (rough.whose, of_file.whose) == ("yours", "yours")
    assert math.isclose(of_file.value, 0.5 * before.value, rel_tol=1e-6)
    wider = dict(plain, **{name: (2 * value[0], *value[1:]) for name, value in plain.items()
                           if name.endswith("values") and len(value) == 2})
    assert math.isclose(rough.value, numbers(found.step, wider)[0].value, rel_tol=1e-5)
    judged = [badges.of_model(found.step.models[1], v)["energy"].worst for v in (values, plain)]
    assert math.isclose(judged[0], 0.5 * judged[1], rel_tol=1e-3)
    own_models.save("mine", found, {mine: texts[mine]}, values)
    saved = opened("mine")
    assert "float half_of(float x) {\n    return 0.25 * x;" in own_models.path_of("mine").read_text("utf-8")
    n = np.array([0.0, 0.0, 1.0])
    np.testing.assert_allclose(saved.rgb(n, n, n), [0.125] * 3, rtol=1e-6)


def test_a_coated_model_follows_the_text_of_its_layers():
    """Twice the slope in D is twice the slope of the model: value, badges, albedo and lobe; the picture's GLSL too."""
    found = step("board/coated+lambert")
    known, source, plain = edit.functions(found), edit.source_of(found), defaults(found)
    plain |= found.derived(plain)
    texts = {"d_beckmann": known["d_beckmann"].text.replace(*TWICE)}
    values = {**plain, **edit.among_values(texts, known, source)}
    wider = (2 * plain["model0_m"], *plain["model0__values"][1:])
    rougher = {**plain, "model0__values": wider, "model0__half_values": wider}
    (mine, other), (course, _), (now, _) = (numbers(found.step, v) for v in (values, rougher, plain))
    assert (mine.whose, other.whose) == ("yours", "the course's")
    assert math.isclose(mine.value, course.value, rel_tol=1e-5) and abs(mine.value / now.value - 1) > 0.1
    judged = [badges.of_model(found.step.models[0], v) for v in (values, rougher)]
    for name in ("energy", "finite"):
        assert math.isclose(judged[0][name].worst, judged[1][name].worst, rel_tol=1e-3)
    for term, swept in ((found.entries[0].term("albedo"), {"theta_v": np.array([0.3, 1.2])}),
                        (found.entries[0].term("half"), {"theta_h": np.array([0.1, 0.4])})):
        np.testing.assert_allclose(*(evaluate(term, v, **swept) for v in (values, rougher)), rtol=1e-3)
    of_schlick = {"f_schlick": known["f_schlick"].text.replace("{", "{ f0 = 0.0;", 1)}
    follows = edit.among_values(of_schlick, known, source)[EDITED]
    assert edit.follows("board:coated", follows) and not edit.follows("board:lambert", follows)


def test_a_scene_of_a_coated_model_is_what_its_numbers_are(ctx):
    """The GLSL of the picture and of the numbers against the model in float64, point by point."""
    from app.board import coated
    from app.gpu.evaluate import evaluate as on_gpu

    rng = np.random.default_rng(3)
    l, v = (d / np.linalg.norm(d, axis=-1, keepdims=True) for d in np.array([0, 0, 2]) + rng.normal(size=(2, 200, 3)))
    n, values = np.array([0.0, 0.0, 1.0]), {"m": 0.2, "rho": (0.1, 0.4, 0.7), "f0": (0.9, 0.6, 0.04)}
    above = (l[:, 2] > 0.02) & (v[:, 2] > 0.02)
    found = on_gpu("coated", {"n": n, "l": l[above], "v": v[above]}, coated.TEXT, uniforms=values)
    np.testing.assert_allclose(found, coated.Coated().rgb(n, l[above], v[above], values), rtol=1e-4)


def test_a_measurement_stays_and_says_so(tmp_path):
    from app.board import merl

    path = tmp_path / "made.binary"
    cells = np.ones((3, *merl.SHAPE))
    path.write_bytes(np.array(merl.SHAPE, "<i4").tobytes() + cells.astype("<f8").tobytes())
    found = step(f"board/cook_torrance+{path}")
    known, source, plain = edit.functions(found), edit.source_of(found), defaults(found)
    texts = {"f_schlick": known["f_schlick"].text.replace("{", "{ f0 = 0.0;", 1)}
    values = {**plain, **found.derived(plain), **edit.among_values(texts, known, source)}
    assert [n.whose for n in numbers(found.step, values)] == ["yours", "measured"]
