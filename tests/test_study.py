"""Error against run time: orders within the bands of the optics reference, silent failures caught, budgets kept."""

import json
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from app.__main__ import main
from app.catalog import step, steps
from app.lesson import Method, Study, Term
from app.plots.efforts import chart, chosen, whole
from app.plots.look import Look
from app.problem import Problem, Usage
from app.study import command
from app.study.integrals import Integral
from app.study.measure import cases, measure, reference, seen
from app.study.names import inputs
from app.study.points import LINE, SQUARE
from app.study.record import Line, Point, Record
from app.study.rules import estimate, is_random, ladder
from app.theme import THEMES

STUDIED = [(found, study) for found in steps() for study in found.step.studies]
EACH = pytest.mark.parametrize(("found", "study"), STUDIED, ids=[f"{f.id}: {study.title[17:]}" for f, study in STUDIED])
COOK_TORRANCE = step("microfacets/cook_torrance").step.studies[0]
GGX = step("geometry_term/smith").step.studies[0]
D_SUM = step("microfacets/distribution").step.studies[0]

# --- silent failures (4.4) -------------------------------------------------------------------------------------------
def only(study: Study, *labels: str) -> Study:
    return replace(study, methods=tuple(m for m in study.methods if m.label in labels))


def test_a_silent_failure_is_caught_and_told():
    found = measure(only(D_SUM, "adaptive, angle", "adaptive, slope"), {"ndf": 2, "m": 1e-4}, 60.0)
    lost, safe = found.lines
    assert [p.words for p in lost.silent][-1] == "converged, but 100 % off" and not safe.silent
    assert all(lost.reach(t) is None for t in (1e-2, 1e-3, 1e-6)) and safe.reach(1e-6)


def test_samples_that_all_miss_are_sure_of_nothing():
    study = replace(COOK_TORRANCE, methods=(Method("random", "random uniform", ladder=(64, 256, 1024)),))
    found = measure(study, {"m": 1e-4, "f0": 1.0, "theta_v": 0.5}, 60.0)
    assert found.lines[0].silent and found.lines[0].silent[0].words == "standard error 0, but 100 % off at θv = 80°"


@pytest.mark.parametrize(("point", "silent"), [
    (Point(1, 9, 0.5, [1.0], claim=1e-6, said="converged"), True),
    (Point(1, 9, 0.5, [1.0], claim=1e-6, said="not_converged"), False),
    (Point(1, 9, 1e-5, [1.0], claim=1e-6, said="converged"), False),
    (Point(1, 9, 0.5, [1.0], claim=0.0), False),
    (Point(1, 999, 0.5, [1.0], claim=0.0), True),
    (Point(1, 999, 0.5, [1.0], claim=0.2), False),
    (Point(1, 999, 0.5, [1.0]), False),
])
def test_what_counts_as_a_silent_failure(point, silent):
    assert point.silent is silent


# --- every study of the course ---------------------------------------------------------------------------------------
@EACH
def test_every_method_of_a_study_comes_near(found, study):
    """At a gentle case each method that is not biased comes near the exact value: all integrate the same thing."""
    job = next(job for job in command.jobs([study.title]) if job.where == "CPU")
    values = seen(job.values | dict.fromkeys(study.worst, 0.5))
    right = reference(study, values)
    for method in study.methods:
        most = 6 if method.rule.startswith("cubature") else 20000
        rungs = [rung for rung in ladder(method, study.over == "wavelengths") if rung <= most]
        value = estimate(study, method, values, rungs[-1], 3).value
        assert value == pytest.approx(right, rel=0.25 if is_random(method) else 0.15), method.label


@EACH
def test_a_study_is_declared_with_what_there_is(found, study):
    labels = [method.label for method in study.methods]
    assert len(set(labels)) == len(labels) and study.why.count(".") <= 3 and len(study.why.split()) < 60
    assert inputs(study) <= {*found.values, *(table.uniform for table in found.step.scene.tables)}
    maps = Integral(study, {}).maps
    for method in study.methods:
        assert set(method.sets) <= set(found.values)
        kind, _, way = method.rule.partition(" ")
        if method.term is None and kind not in ("semi-analytic", "lebedev", "pieces"):
            assert way in maps and kind in {*(LINE if way == "line" else SQUARE), "cubature"}
    for _, given in cases(study):
        assert set(given) <= set(found.values)


@pytest.mark.parametrize("kinds", [SQUARE, LINE], ids=["square", "line"])
def test_the_weights_of_points_sum_to_one(kinds):
    for name, points in kinds.items():
        at, weights = points(64 if name == "tiles" else 256, 5)
        assert weights.sum() == pytest.approx(1, rel=1e-12), name
        assert at.shape == (len(weights), 2) and at.min() >= 0 and at.max() <= 1


# --- the record ------------------------------------------------------------------------------------------------------
def line(*errors: float) -> Line:
    return Line("a", [Point(k, 4**k, e, [1e-3 * 4**k]) for k, e in enumerate(errors)])


def test_a_tolerance_is_reached_when_it_is_kept():
    found = line(1e-1, 1e-4, 1e-2, 5e-4, 1e-5)
    assert found.reach(1e-3).rung == 3 and found.reach(1e-2).rung == 1 and found.reach(1e-6) is None
    found.points[3].times = [9.0]  # the clock wavers, and a smaller error is not reached before a larger one
    assert found.reach(1e-3).rung == found.reach(1e-4).rung == 4


def test_the_winner_is_the_first_in_time_and_not_the_reference():
    slow, fast, exact = line(1e-1, 1e-3), line(1e-3, 1e-5), Line("exact", [Point(1, 1, 0.0, [1e-9])], reference=True)
    record = Record("a/b", "t", "", {}, {"": 1.0}, [slow, fast, exact])
    assert record.winner(1e-3)[0] is fast and record.winner(1e-9) is None
    assert record.beside(1e-3) == [] == record.beside(1e-9)
    slow.points[1].times = [1e-3, 8e-3, 9e-3, 9e-3]  # in a quarter of the runs it was as fast
    fast.points[0].times = [1e-3, 1e-3, 6e-3, 9e-3]
    assert record.beside(1e-3) == [slow]


def test_an_order_has_a_spread():
    p, spread = line(*(0.3 * 4 ** (-0.5 * k) for k in range(8))).order
    assert p == pytest.approx(0.5) and spread < 1e-12
    assert line(0.1, 0.01).order is None


def test_a_budget_is_kept_by_the_clock_it_is_measured_with(monkeypatch):
    """A clock that goes by work: each look at it is a millisecond, so that no machine is too slow for this test."""
    now = iter(np.arange(0, 1e4, 1e-3))
    monkeypatch.setattr("app.study.measure.perf_counter", lambda: float(next(now)))
    found = measure(COOK_TORRANCE, {"m": 0.1, "f0": 1.0}, 0.5)
    assert 0.2 < found.seconds < 0.7 and all(one.points for one in found.lines)


# --- the picture -----------------------------------------------------------------------------------------------------
AREA = step("lights/area_work").step.studies[0]


def area_record(points: int = 4) -> Record:
    lines = [Line(m.label, [Point(k, 4**k, 10.0 ** -(k + i), [1e-4 * 4**k] * 3) for k in range(points)])
             for i, m in enumerate(AREA.methods)]
    lines[-1] = Line(AREA.methods[-1].label, [Point(1, 1, 0.0, [1e-4])], reference=True)
    return Record("lights/area_work", AREA.title, "panel", {}, {"": 1.0}, lines)


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
@pytest.mark.parametrize("size", [(960, 720), (400, 300), (300, 260)])
def test_points_stand_where_they_are_said_to_be(theme, size):
    record, look = area_record(), Look(theme, size)
    drawn, spots = chart(AREA, record, look, size[::-1], {"sampling": 5, "level": 2})
    assert drawn.shape == (size[1], size[0], 3) and len(spots) == sum(len(one.points) for one in record.lines)
    there = [drawn[int(spot.y), int(spot.x)] / 255 for spot in spots]
    bare = [spot for spot, ink in zip(spots, there, strict=True) if np.abs(ink - look.background).max() < 0.15]
    assert not bare


def test_a_click_sets_the_method_and_its_cost():
    method = next(m for m in AREA.methods if m.label == "Gauss, angle")
    assert chosen(method, Point(3, 64, 0.1, [1.0])) == {"sampling": 5, "level": 3}
    counted = next(m for m in step("solid_angle/patch").step.studies[0].methods if m.label == "Fibonacci")
    assert chosen(counted, Point(1024, 1024, 0.1, [1.0])) == {"samples": 1024}
    tiles = next(m for m in step("brdfs/lambert").step.studies[0].methods if m.label == "tiles")
    assert chosen(tiles, Point(6, 144, 0.1, [1.0])) == {"tile_rows": 6, "half_angle": pytest.approx(np.pi / 2)}


def test_a_pointer_finds_the_nearest_point_that_can_be_set():
    from app.plots.wire import Spot
    from app.viewer.study_panel import StudyPanel, nearest

    far, near, other = Spot(10, 10, "", {"level": 9}), Spot(50, 50, "", {"level": 2}), Spot(51, 50, "", {})
    assert nearest((far, near, other), 51, 50, 8) is near and nearest((far, near), 30, 30, 8) is None
    from app.session import Session

    panel = StudyPanel(SimpleNamespace(session=Session("lights/area_work")))
    assert panel.possible(far) == {"level": 4}  # the scene's most
    panel.choose({"sampling": 5, "level": 4})
    assert panel.app.session.values["sampling"] == 5 and panel.app.session.values["level"] == 4


# --- the command -----------------------------------------------------------------------------------------------------
def test_the_command_writes_a_page_that_needs_no_network(tmp_path, capsys, monkeypatch):
    real = command.record_of
    monkeypatch.setattr(command, "record_of", lambda job, budget: real(job, 0.4))
    every = command.jobs
    monkeypatch.setattr(command, "jobs", lambda topics: list(every(topics))[:4])
    assert main(["study", "microfacets/distribution", "--json", "-o", str(tmp_path / "out")]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [one["case"] for one in data["studies"]] == [f"Beckmann, m = {m}" for m in ("1", "0.1", "0.01", "10⁻⁴")]
    assert {"processor", "numpy", "scipy", "python"} <= set(data["machine"])
    for one in data["studies"]:
        for method in one["methods"]:
            assert method["points"] and all(p["time"] > 0 for p in method["points"]), method["label"]
    failed = [p["silent_failure"] for m in data["studies"][3]["methods"] for p in m["points"] if m["label"]
              == "adaptive, angle"]
    assert "converged, but 100 % off" in failed
    page = (tmp_path / "out" / "index.html").read_text("utf-8")
    assert not re.search(r"(src|href|srcset)=\"(?!data:|#)", page) and "converged, but 100 % off" in page
    assert len(list((tmp_path / "out").glob("*.png"))) == 8 and (tmp_path / "out" / "study.json").exists()


def test_what_the_budget_had_no_time_for_is_told(monkeypatch, capsys):
    now = iter([0.0, 0.5, *np.arange(99, 999.0)])  # the command begins, one study, and the time is up
    monkeypatch.setattr("app.study.command.perf_counter", lambda: float(next(now)))
    assert main(["study", "solid_angle/patch", "--budget", "9"]) == 1
    out, err = capsys.readouterr()
    assert "w = 1.2 m" in out and "w = 0.2 m" not in out
    assert err.strip() == ("halfway: the budget was up before 2 of 3 studies began, from solid_angle/patch, w = 0.2 m "
                           "on; name topics, or give more with --budget.")


def test_an_interruption_keeps_what_is_done(tmp_path, monkeypatch, capsys):
    real, done = command.record_of, []

    def interrupted(job, budget):
        if done:
            raise KeyboardInterrupt
        done.append(job)
        return real(job, 0.1)

    monkeypatch.setattr(command, "record_of", interrupted)
    assert main(["study", "radiometry/eye", "-o", str(tmp_path)]) == 130
    out, err = capsys.readouterr()
    assert "halfway: interrupted: 1 of 2 studies are done, and kept." in err
    assert "T = 2700 K" in out and "6500" not in out and (tmp_path / "index.html").exists()


@pytest.mark.parametrize(("words", "sentence"), [
    (["lumens", "nonsense"], "there is no study of nonsense."),
    (["--budget", "0"], "--budget 0: a study needs at least 2 seconds."),
    (["radiometri/eye"], "there is no study of radiometri/eye. Did you mean radiometry/eye"),
])
def test_what_cannot_be_studied_is_told(words, sentence, capsys):
    assert main(["study", *words]) == Usage.code
    assert capsys.readouterr().err.startswith(f"halfway: {sentence}")


def test_a_rule_that_does_not_exist_is_told():
    study = Study("A", 1.0, (), "", over="halfways", integrand=(Term("d_beckmann"),), width="m")
    for rule, sentence in (("random unifrom", "has no map unifrom. Did you mean uniform"),
                           ("randem uniform", "there are no points randem. Did you mean random")):
        with pytest.raises(Problem, match=re.escape(sentence)):
            estimate(study, Method("", rule), {"m": 0.3}, 16, 0)


def test_the_gpu_draws_the_same_study(capsys):
    """Pixels against the float64 closed form: Gauss points come down to float32, and errors fall as on the CPU."""
    from app.study.pixels import measure_pixels

    job = next(job for job in command.jobs(["lights/area_work"]) if job.where == "GPU")
    small = replace(AREA, methods=tuple(replace(m, ladder=(1, 2, 3)) if m.cost else m for m in AREA.methods))
    found = {one.label: [p.error for p in one.points] for one in measure_pixels(small, job.values, 60.0).lines}
    assert found["closed form"][0] < 1e-5 and found["Gauss, angle"][-1] < 1e-3
    assert found["random"][0] > 1.5 * found["random"][1] > 2.2 * found["random"][2]


def test_the_pictures_of_a_record_are_as_large_as_asked():
    for theme in THEMES.values():
        assert whole(AREA, area_record(), (960, 720), theme).size == (960, 720)
