"""Assignments are data that refuses what is wrong with a sentence: file, key, value, what would be right."""

import numpy as np
import pytest

from app.grade.assignment import assignments, load
from app.grade.points import draw
from app.grade.questions import layout, pixels, questions
from app.problem import Usage
from app.quantities import TABLE

GOOD = """
title = "Mine"
chapter = "fresnel"
due = 2026-12-01T23:59:00+01:00
late = { per_day = 0.1, days = 3 }

[[task]]
function = "f_schlick"
text = "Write it."
points = 2
[[task.region]]
name = "all"
f0 = [0.02, 0.9]
"""
every = pytest.mark.parametrize("name", assignments())


def written(tmp_path, old="", new=""):
    assert old in GOOD
    path = tmp_path / "mine.toml"
    path.write_text(GOOD.replace(old, new) if old else GOOD, "utf-8")
    return path


def test_a_lecturers_own_file(tmp_path):
    found = load(written(tmp_path))
    assert (found.id, found.points, found.late_per_day, found.late_days) == ("mine", 2, 0.1, 3)
    assert found.due.isoformat() == "2026-12-01T23:59:00+01:00"
    assert found.tasks[0].arguments == ("l_dot_h", "f0") and found.digest != load("fresnel").digest


@pytest.mark.parametrize(("old", "new", "sentence"), [
    ('title = "Mine"', "", "mine.toml: the file has no title; right is a line of words."),
    ('"fresnel"', '"frensel"', "mine.toml: chapter is 'frensel'; there is no such chapter. Did you mean fresnel?"),
    ('"f_schlick"', '"f_shlick"', "task 1 (f_shlick) names no function of the course. Did you mean f_schlick"),
    ("points = 2", "points = -2", "mine.toml: task 1 (f_schlick) points is -2; right is a number above 0."),
    ("points = 2", "points = nan", "mine.toml: task 1 (f_schlick) points is nan; right is a number above 0."),
    ("2026-12-01T23:59:00+01:00", "2026-12-01", "mine.toml: due is 2026-12-01; right is a time with its zone"),
    ("points = 2", "", "mine.toml: task 1 (f_schlick) has no points; right is a number above 0."),
    ("points = 2", "points = 2\npiont = 3", "task 1 (f_schlick) has the key piont, which says nothing here"),
    ("f0 = [0.02, 0.9]", "f0 = [0.9, 0.02]", "region 1 (all), f0 = [0.9, 0.02]: [0.9, 0.02] is no range; right is the "
                                             "smaller number first."),
    ("f0 = [0.02, 0.9]", "f0 = [0.02, 9]", "f0 = [0.02, 9]: 9 is outside what f0 can be, 0 to 0.99."),
    ("f0 = [0.02, 0.9]", 'f0 = "any"', "f0 = 'any': 'any' is no domain; right are a number, [low, high]"),
    ("f0 = [0.02, 0.9]", "f0 = { logg = [0.1, 0.2] }", "there is no form logg; the forms are choose, log, times"),
    ("f0 = [0.02, 0.9]", 'f0 = { times = "eta", by = [1, 2] }', "times speaks of 'eta', which is no other argument."),
    ("f0 = [0.02, 0.9]", "f00 = [0.02, 0.9]", "has the key f00, which says nothing here; there are name, visible"),
    ("f0 = [0.02, 0.9]", "visible = 0\nhidden = 0", "has no points; right is visible or hidden above 0."),
    ("f0 = [0.02, 0.9]", '[[task.property]]\nname = "reciprocity"', "it has no light and eye to swap"),
    ("f0 = [0.02, 0.9]", '[[task.property]]\nname = "recipocity"', "one of reciprocity, positivity, bound, energy"),
    ("2026-12-01T23:59:00+01:00", "2026-12-01T23:59:00", "right is a time with its zone"),
    ("per_day = 0.1", "per_day = 10", "mine.toml: late per_day is 10; right is a share of the points, 0 to 1."),
    ('title = "Mine"', 'title = "Mine', "mine.toml is no TOML"),
    ('function = "f_schlick"', 'exercise = "fresnel/shlick"', "no such exercise. Did you mean fresnel/schlick?"),
    ('function = "f_schlick"', 'function = "f_schlick"\nreference = "no.py"', "right is a Python file beside this one"),
    ('function = "f_schlick"', 'function = "ies_candela"', "is no number that varies from point to point"),
    ("chapter =", 'languages = ["rust"]\nchapter =', 'right is a list of "python" and "glsl".'),
])
def test_what_is_wrong_is_told(tmp_path, old, new, sentence):
    with pytest.raises(Usage) as told:
        load(written(tmp_path, old, new))
    assert sentence in str(told.value) and "mine.toml" in str(told.value)


def test_a_reference_that_does_not_run_is_told(tmp_path):
    (tmp_path / "mine.py").write_text("import nothing_like_it\n", "utf-8")
    with pytest.raises(Exception, match=r"mine\.py does not run: ModuleNotFoundError"):
        load(written(tmp_path, 'function = "f_schlick"', 'function = "f_mine"\nreference = "mine.py"'))


def test_there_is_one_a_chapter_and_a_project():
    chapters = [load(name).chapter for name in assignments()]
    assert len(set(chapters)) == 8 and len(chapters) == 9
    project = load("project")
    assert project.tasks[0].picture and project.tasks[0].width == 3


def test_an_unknown_name():
    with pytest.raises(Usage, match=r"there is no assignment fresnell\. Did you mean fresnel\?"):
        load("fresnell")


# --- points ----------------------------------------------------------------------------------------------------------
@every
def test_points_are_the_same_for_everyone_and_hidden_ones_are_others(name):
    one = load(name)
    first, second = questions(one), questions(one)
    hidden, other = questions(one, "a", True), questions(one, "b", True)
    for a, b in zip(first, second, strict=True):
        assert a.id == b.id and all(np.array_equal(a.args[key], b.args[key]) for key in a.args)
    drawn = [(a, b) for a, b in zip(hidden, other, strict=True) if "picture" not in a.id]
    assert all(any(not np.array_equal(a.args[key], b.args[key]) for key in a.args) for a, b in drawn)
    assert not {q.id for q in first} & {q.id for q in hidden}


@every
def test_glsl_is_asked_what_float32_can_hold_and_directions_are_unit(name):
    for q in questions(load(name)) + questions(load(name), "s", True):
        for key, x in q.args.items():
            assert np.all(np.isfinite(x)) and len(x) == q.count
            if q.language == "glsl":
                assert np.array_equal(x, x.astype(np.float32)), (q.id, key)
            if key in ("n", "l", "v", "h"):
                assert np.allclose(np.linalg.norm(x, axis=1), 1, atol=1e-6)


@every
def test_the_judge_knows_what_every_row_is_for(name):
    one = load(name)
    for q in questions(one) + questions(one, "s", True):
        task = one.task(q.function)
        rows = layout(task, "hidden" in q.id)
        if "picture" in q.id:
            assert q.count == pixels(task.picture, task.arguments, "hidden" in q.id)[1].sum()
        else:
            assert [row.first for row in rows] == np.cumsum([0, *(row.count for row in rows)])[:-1].tolist()
            assert sum(row.count for row in rows) == q.count


def test_domains_draw_what_they_say():
    from app.grade.points import domain

    names = ("n", "l", "v", "h", "m", "exponent", "hotspot", "falloff", "off_axis")
    given = {"n": "any", "l": [88, 89.9], "v": {"mirror": [0, 2]}, "h": {"slopes": [1, 2], "of": "m"},
             "m": {"log": [0.01, 0.1]}, "exponent": {"choose": [1, 2]}, "hotspot": [5, 40],
             "falloff": {"times": "hotspot", "by": [1.2, 1.9]}, "off_axis": {"between": ["hotspot", "falloff"]}}
    got = draw({name: domain(name, given[name], names) for name in names}, np.random.default_rng(0), 500)
    dot = lambda a, b: np.sum(got[a] * got[b], -1)  # noqa: E731
    angle = np.degrees(np.arccos(dot("n", "l")))
    assert angle.min() > 87.99 and angle.max() < 89.91
    mirror = 2 * dot("n", "l")[:, None] * got["n"] - got["l"]
    assert np.sum(mirror * got["v"], -1).min() > np.cos(np.radians(2.01))
    slope = np.sqrt(1 / dot("n", "h") ** 2 - 1) / got["m"]
    assert slope.min() > 0.99 and slope.max() < 2.02
    assert 0.0099 < got["m"].min() < 0.012 and set(got["exponent"]) == {1, 2}
    assert np.all((got["hotspot"] <= got["off_axis"] + 1e-6) & (got["off_axis"] <= got["falloff"] + 1e-6))
    assert got["hotspot"].max() < np.radians(40.01) and TABLE["hotspot"].unit == "rad"
