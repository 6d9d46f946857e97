"""The judge: right is right, nothing earns nothing, and what it writes is strict JSON."""

import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from app.grade import agree, late, picture, properties
from app.grade.assignment import assignments, load
from app.grade.judge import judge
from app.grade.question import Reply
from app.grade.questions import layout, questions
from app.optics import twin

LOADED = {name: load(name) for name in assignments()}
ASKED = {name: questions(one) + questions(one, "secret", True) for name, one in LOADED.items()}
every = pytest.mark.parametrize("name", LOADED)


def shape(question):
    return (question.count,) if question.width == 1 else (question.count, question.width)


def right(name):
    one = LOADED[name]
    return [Reply(q.id, np.asarray(one.task(q.function).reference(**q.args), float), seconds=0.01)
            for q in ASKED[name]]


def judged(name, replies):
    return judge(LOADED[name], ASKED[name], replies, dict.fromkeys((q.id for q in ASKED[name]), 0.02))


def answered(name, how):
    with np.errstate(all="ignore"):
        return judged(name, [Reply(q.id, np.array(how(q), float), seconds=0.01) for q in ASKED[name]])


@every
def test_the_reference_has_all_points(name):
    result = judged(name, right(name))
    assert (result.score, result.max, result.verdict) == (LOADED[name].points, LOADED[name].points, "pass")
    assert 0 < result.visible_max < result.max and result.visible_score == result.visible_max
    assert result.suspects == () and all(test.verdict == "pass" and not test.message for test in result.tests)


@every
def test_the_reference_in_single_precision_has_all_points(name):
    with np.errstate(all="ignore"):
        single = [replace(one, values=one.values.astype(np.float32).astype(float)) for one in right(name)]
    result = judged(name, single)
    assert result.score == result.max, [test for test in result.tests if test.verdict != "pass"]


def echo(question, last=False):
    same = [x for x in question.args.values() if x.shape == shape(question)]
    return same[-1 if last else 0] if same else np.zeros(shape(question))


NOTHING = {"zero": lambda q: np.zeros(shape(q)), "one": lambda q: np.ones(shape(q)),
           "a half": lambda q: np.full(shape(q), 0.5), "the first argument": echo,
           "the last argument": lambda q: echo(q, True),
           "chance": lambda q: np.random.default_rng(1).random(shape(q))}


@every
@pytest.mark.parametrize("how", NOTHING)
def test_nothing_earns_nothing(name, how):
    """Constants, arguments handed back and chance have no property marks either."""
    result = answered(name, NOTHING[how])
    assert result.score < 0.05 * result.max


@every
def test_nan_is_never_right(name):
    result = answered(name, lambda q: np.full(shape(q), np.nan))
    assert result.score == 0 and {test.verdict for test in result.tests} <= {"nonfinite", "skipped", "wrong"}
    assert answered(name, lambda q: np.full(shape(q), np.inf)).score == 0


def in_python(replies):
    return [Reply(r.id, None, "missing", "no file") if r.id.endswith("/glsl") else r for r in replies]


def test_one_nan_costs_its_point_and_no_more():
    replies = in_python(right("fresnel"))
    replies[0].values[10] = np.nan
    result = judged("fresnel", replies)
    hurt = [test for test in result.tests if test.verdict != "pass"]
    assert 0.95 * result.max < result.score < result.max
    assert hurt[0].message.endswith("values are no numbers.") and hurt[0].wrong == 1


def test_ten_grazing_points_are_not_drowned():
    """Wrong at grazing alone costs that region's whole weight, however few points it has."""
    one = LOADED["microfacets"].task("brdf_cook_torrance")
    replies = right("microfacets")
    for q, reply in zip(ASKED["microfacets"], replies, strict=True):
        if q.function == one.function:
            for rows in layout(one, "hidden" in q.id):
                if rows.name == "grazing":
                    reply.values[rows.slice] *= 2
    result = judged("microfacets", replies)
    lost = sum(test.max - test.score for test in result.tests if test.region == "grazing")
    assert lost == pytest.approx(sum(test.max for test in result.tests if test.region == "grazing"))
    assert result.max - result.score >= lost


@pytest.mark.parametrize("verdict", ["missing", "compile_error", "timeout_cpu", "crash"])
def test_what_does_not_answer_says_why_and_hurts_no_neighbour(verdict):
    replies = [Reply(r.id, None, verdict, "its line 3") if r.id.startswith("f_schlick/") else r
               for r in right("fresnel")]
    result = judged("fresnel", replies)
    assert result.score == 6 and result.verdict == "partial"
    assert {test.verdict for test in result.tests if test.function == "f_schlick"} == {verdict}
    assert {test.message for test in result.tests if test.function == "f_schlick"} == {"its line 3"}


def test_no_answer_is_ungraded_and_never_zero():
    assert judged("fresnel", in_python(right("fresnel"))[1:]).verdict == "ungraded"
    assert judged("fresnel", right("fresnel")[1:]).verdict == "pass", "the other language is right"


def test_of_two_languages_the_better_one_counts():
    result = judged("fresnel", in_python(right("fresnel")))
    assert result.score == 9 and {test.language for test in result.tests} == {"python"}


@pytest.mark.parametrize("language", ["python", "glsl"])
@pytest.mark.parametrize("exponent", [1e3, 1e5, 1e6, 1e7])
def test_a_sound_float32_power_passes(exponent, language):
    """What rounding n.h alone does to a lobe of exponent 10^6 is no mistake; a tenth more in the exponent is one."""
    task = LOADED["brdfs"].task("lobe_power")
    c = (1 - np.linspace(0, 3, 200) / exponent).astype(np.float32)
    args = {"n_dot_h": c.astype(float), "exponent": np.full(200, exponent)}
    known = agree.truth(task, args, language)
    off = np.float32(exponent) * np.log(c, dtype=np.float32)  # as llvmpipe does it, with a log of float32
    sound = np.exp(off.astype(float)) if language == "glsl" else c.astype(float) ** exponent
    assert np.all(agree.agrees(known, sound))
    if exponent < 1e5:
        assert not np.any(agree.agrees(known, known.value * 1.01)[1:])
    assert not np.any(agree.agrees(known, -known.value)) and not np.any(agree.agrees(known, 0 * known.value))


@pytest.mark.parametrize("form", ["(1-c)(1+c)", "c² - 1"])
def test_both_forms_of_beckmann_pass_where_n_dot_h_is_given(form, tmp_path):
    """From the cosine itself both are sound: the cosine's rounding costs more than the form."""
    (tmp_path / "own.py").write_text("import numpy as np\ndef d(n_dot_h, m):\n    c = n_dot_h\n    return np.exp("
                                     "-(1 - c) * (1 + c) / (c * m) ** 2) / (np.pi * m**2 * c**4)\n", "utf-8")
    (tmp_path / "own.toml").write_text("""
title = "own"
chapter = "microfacets"
[[task]]
function = "d"
reference = "own.py"
text = "..."
points = 1
[[task.region]]
name = "all"
n_dot_h = [0.99, 0.999999]
m = [0.01, 0.5]
""", "utf-8")
    one = load(tmp_path / "own.toml")
    asked = questions(one, languages=("glsl",))
    c, m = (asked[0].args[name].astype(np.float32) for name in ("n_dot_h", "m"))
    t = (1 - c) * (1 + c) if form == "(1-c)(1+c)" else 1 - c * c
    value = np.exp(-t / (c * m) ** 2) / (np.float32(np.pi) * m**2 * c**4)
    assert judge(one, asked, [Reply(asked[0].id, value.astype(float))]).verdict == "pass"


def test_reciprocity_and_energy_are_properties_of_the_answers():
    """A BRDF of the right values that forgets reciprocity elsewhere loses that property alone."""
    task = LOADED["brdfs"].task("brdf_lambert")
    replies = right("brdfs")
    for q, reply in zip(ASKED["brdfs"], replies, strict=True):
        if q.function == task.function:
            for rows in layout(task, "hidden" in q.id):
                if rows.kind == "swapped":
                    reply.values[rows.slice] *= 1.5
                if rows.kind == "energy":
                    reply.values[rows.slice] *= 2
    result = judged("brdfs", replies)
    lost = {test.region for test in result.tests if test.verdict != "pass"}
    assert lost == {"reciprocity", "energy"}
    assert "no more light leaves than arrives" in next(t.message.lower() for t in result.tests if t.region == "energy")


def test_the_sum_over_the_hemisphere_is_the_albedo():
    n = np.repeat([[0.0, 0.0, 1.0]], 3, 0)
    args = properties.hemisphere({"n": n, "l": n, "v": np.repeat([[0.6, 0.0, 0.8]], 3, 0), "m": np.full(3, 0.5),
                                  "f0": np.full(3, 1.0)})
    fine, apart = properties.albedo(twin("brdf_cook_torrance")(**args))
    assert fine == pytest.approx(twin("albedo_cook_torrance")(np.arccos(0.8), 0.5, 1.0), rel=2e-2)
    assert np.all(apart < 0.02)
    lambert, none = properties.albedo(np.full(len(args["n"]), 1 / np.pi))
    assert lambert == pytest.approx(1, rel=1e-12) and np.all(none < 1e-12)


# --- the picture -----------------------------------------------------------------------------------------------------
def of_picture(change):
    one = LOADED["project"]
    replies = right("project")
    for q, reply in zip(ASKED["project"], replies, strict=True):
        if "picture" in q.id:
            reply.values[:] = change(reply.values)
    return [test for test in judge(one, ASKED["project"], replies).tests if test.region == "picture"]


def test_a_missing_highlight_fails_the_picture():
    tests = of_picture(lambda x: np.minimum(x, np.percentile(x, 90, axis=0)))
    assert all(test.verdict in ("partial", "wrong") and test.score < 0.7 * test.max for test in tests)
    assert [figure.label for figure in tests[0].figures][:3] == ["expected", "yours", "signed error"]
    assert all(not test.figures for test in tests if test.visibility == "hidden"), "hidden points are not sent back"


def test_a_black_picture_and_one_nan_have_nothing():
    assert all(test.score == 0 for test in of_picture(lambda x: 0 * x))
    def hole(x):
        x = x.copy()
        x[77] = np.nan
        return x
    assert all(test.score == 0 and test.verdict == "nonfinite" for test in of_picture(hole))


def test_a_picture_within_rounding_passes():
    assert all(test.verdict == "pass" for test in of_picture(lambda x: x * (1 + 1e-4)))


def test_a_silhouettes_pixel_may_be_its_neighbours():
    mask = np.zeros((9, 9), bool)
    mask[2:7, 2:7] = True
    expected = np.where(mask[..., None], np.arange(9)[:, None, None] * 1.0, 0.0) * np.ones(3)
    got = expected.copy()
    got[2] = expected[3]  # the upper rim shows what is one pixel below it
    assert picture.errors(expected, np.where(mask[..., None], got, 0.0), mask)[1] == 0
    got[4, 4] += 1
    assert picture.errors(expected, got, mask)[1] > 0


# --- what is written -------------------------------------------------------------------------------------------------
def test_the_result_is_strict_json():
    result = answered("brdfs", lambda q: np.full(shape(q), np.nan))
    text = json.dumps(result.as_json(), allow_nan=False)
    found = json.loads(text)
    assert found["max"] == 10 and found["schema"].startswith("halfway-result")
    worst = next(test["worst"] for test in found["tests"] if test["worst"])
    assert all(test["worst"] is None for test in found["tests"] if test["visibility"] == "hidden"), "not sent back"
    assert worst["got"] == "nan" or worst["got"][0] == "nan"
    assert {"id", "group", "weight", "score", "max", "verdict", "visibility", "region", "points", "wrong", "worst",
            "message_key", "rationale", "help", "requires", "figures"} <= set(found["tests"][0])


def test_the_same_answers_give_the_same_bytes_in_any_order():
    replies = right("lights")
    for reply in replies[::2]:
        reply.values[:] *= 1.01
    first = judged("lights", replies)
    second = judged("lights", replies[::-1])
    assert json.dumps(first.as_json()) == json.dumps(second.as_json())


def test_the_late_rule():
    due = datetime(2026, 12, 1, 12, tzinfo=UTC)
    one = replace(LOADED["fresnel"], due=due, late_per_day=0.1, late_days=3)
    shares = {hours: one.share_when(due + timedelta(hours=hours)) for hours in (-5, 0, 1, 24, 25, 72, 73)}
    assert shares == {-5: 1, 0: 1, 1: 0.9, 24: 0.9, 25: 0.8, 72: pytest.approx(0.7), 73: 0}
    marks = late.applied({"score": 9.0, "visible_score": 4.0, "max": 9.0}, one, due + timedelta(hours=1))
    assert (marks["score"], marks["visible_score"], marks["max"], marks["late_share"]) == (8.1, 3.6, 9, 0.9)
    assert late.applied({"score": None}, one, due + timedelta(days=9))["score"] is None


def test_speed_pays_when_it_is_right():
    slow = [Reply(r.id, r.values, seconds=10.0) for r in right("fresnel")]
    result = judged("fresnel", slow)
    assert result.score == pytest.approx(9 - 0.3)
    told = next(test.message for test in result.tests if test.group == "runtime")
    assert told.startswith("it takes more than 10 times")
