"""halfway stress: the twins keep the rule at their extremes, the naive forms do not, and a fault is found."""

import json
import shlex

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings

from app import calculator, catalog, optics
from app.__main__ import main
from app.stress import command, energy, judge
from app.stress.copies import EXTENDED, twin_of
from app.stress.grid import ladder, points
from app.stress.heat import FAULT, heat_map, panel, rungs
from app.stress.judge import GLSL, NUMPY32, NUMPY64, judged
from app.stress.paste import line
from app.stress.ranges import kind
from app.stress.scenes import Player, played
from app.tolerance import FACTOR
from tests.test_state import states

NAMES = sorted(optics.names())
STABLE = [name for name in NAMES if kind(name) == "stable"]


@pytest.mark.parametrize("name", STABLE)
def test_a_stable_form_keeps_the_rule_at_its_extremes(name, ctx):
    found = judged(name, ctx)
    assert not found.fails, "\n".join(f"{e.form}, {e.error:.3g}: {e.got} for {e.true}: {e.paste}"
                                      for e in found.examples) or f"{found.stored} {found.albedo}"


@pytest.mark.parametrize("name", [name for name in NAMES if kind(name) == "naive"])
def test_a_naive_form_breaks_it(name, ctx):
    """Else it teaches nothing, and the grid does not reach where it should."""
    found = judged(name, ctx)
    assert not found.fails and found.examples and found.against != name
    assert max(form.worst for form in found.forms) > FACTOR


def test_the_grid_reaches_the_extremes_that_were_asked_for():
    assert {1e-5, 10.0} <= {float(f"{x:.6g}") for x in ladder("m")}
    cosines = ladder("n_dot_l")
    assert cosines[0] == 0 and cosines[-1] == 1 and cosines[-2] == 1 - 2.0**-24 and 0 < cosines[1] < 1e-38
    assert max(ladder("exponent")) == 1e7
    assert 1.0 in ladder("eta") and any(0 < abs(x - 1) < 2e-7 for x in ladder("eta")) and min(ladder("eta")) < 0.5
    assert min(ladder("half_angle")) < 2e-12 and max(ladder("radius")) / min(ladder("radius")) > 1e9
    a = points("brdf_cook_torrance")
    assert np.any(np.all(a["l"] == -a["v"], -1)) and np.any(np.all(a["l"] == a["v"], -1))
    flat = points("solid_angle_triangle")
    assert np.any(np.all(flat["a"] == flat["b"], -1) | (np.linalg.norm(np.cross(flat["a"], flat["b"]), axis=-1) == 0))


def test_a_copy_has_its_own_precision():
    args = {"half_angle": np.array([1e-3, 0.5])}
    exact = optics.twin("solid_angle_cone")(**args)
    small = twin_of("solid_angle_cone", np.float32)(half_angle=np.float32([1e-3, 0.5]))
    assert small.dtype == np.float32 and np.allclose(small, exact, rtol=1e-6) and np.any(small != exact)
    naive = twin_of("solid_angle_cone_naive", np.float32)(half_angle=np.float32([1e-3, 0.5]))
    assert abs(naive[0] / exact[0] - 1) > 1e-2
    if EXTENDED:
        long = twin_of("solid_angle_cone", EXTENDED)(half_angle=EXTENDED("0.5"))
        assert long.dtype == EXTENDED
        with mp.workdps(25):
            assert abs(long - EXTENDED(str(4 * mp.pi * mp.sin(mp.mpf("0.25")) ** 2))) < 1e-18


def test_the_judge_finds_what_is_broken(monkeypatch, ctx):
    """A twin with a digit too few, a NaN, a negative value: each is counted."""
    def broken(half_angle):
        value = optics.own("solid_angle_cone")(half_angle) * (1 + 1e-12)
        return np.where(half_angle > 3, np.nan, np.where(half_angle > 1, -value, value))

    found = optics.twin
    monkeypatch.setattr(judge, "twin", lambda name: broken if name == "solid_angle_cone" else found(name))
    report = judged("solid_angle_cone", ctx)
    worst = {form.name: form for form in report.forms}
    assert report.fails and worst[NUMPY64].nan and worst[NUMPY64].negative
    assert worst[NUMPY64].beyond == report.points


def test_golden_values_judge_too():
    found = judged("d_at")
    assert found.stored is not None and found.stored[0] > 10 and max(found.stored[1:]) <= FACTOR


def test_energy_that_is_gained_is_told():
    printed = energy.most("brdf_cook_torrance_printed")
    assert printed is not None and printed.gains and printed.largest == pytest.approx(4 / np.pi * 0.99, abs=0.02)
    assert not energy.most("brdf_cook_torrance").gains
    assert energy.most("d_beckmann") is None and energy.most("brdf_eon_at") is None


@pytest.mark.parametrize("name", ["d_beckmann_naive", "solid_angle_polygon_naive", "solid_angle_cone_naive",
                                  "ies_towards", "solid_angle_mesh", "random_number", "f_dielectric"])
def test_a_worst_point_can_be_pasted(name):
    """Into a shell: the command computes exactly this point."""
    args = points(name)
    value = np.atleast_1d(optics.twin(name)(**args))
    i = len(value) - 1
    words = shlex.split(line(name, args, i, len(value)))
    if words[0] == "echo":
        assert words[2:] == ["|", "halfway", "eval", "--json"]
        given = calculator.answer(0, calculator.read_cases(words[1])[0], "python")["value"]
    else:
        assert words[:3] == ["halfway", "eval", name]
        bound = calculator.bound(name, dict(calculator.split(word) for word in words[3:]))
        given = calculator.results(name, bound, "python")["value"]
    assert np.array_equal(np.squeeze(given), value[i], equal_nan=True)


def test_the_command_tells_and_its_code_is_right(capsys):
    assert main(["stress", "d_beckmann", "d_beckmann_naive"]) == 0, "what is naive may fail"
    said = capsys.readouterr().out
    assert "naive: what it loses" in said and "halfway eval d_beckmann_naive n=" in said
    assert ("2 functions" in said and "extended precision" in said) or not EXTENDED
    assert main(["stress", "d_beckmann_naive", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["functions"][0]
    assert found["kind"] == "naive" and found["against"] == "d_beckmann" and not found["fails"]
    assert {form["form"] for form in found["forms"]} >= {GLSL, NUMPY32}


def test_a_failing_stable_form_gives_1(monkeypatch, capsys):
    monkeypatch.setattr(judge, "kind", lambda name: "stable")
    assert main(["stress", "solid_angle_cone_naive"]) == 1
    assert "fails" in capsys.readouterr().out


def test_what_cannot_be_asked(capsys):
    for words, sentence in ((["d_bekmann"], "Did you mean"), (["--scenes", "d_beckmann"], "scenes alone")):
        assert main(["stress", *words]) == 2
        assert sentence in capsys.readouterr().err


def test_an_interruption_keeps_what_is_done(monkeypatch, capsys):
    found = command.judged

    def impatient(name):
        if name == "d_beckmann":
            raise KeyboardInterrupt
        return found(name)

    monkeypatch.setattr(command, "judged", impatient)
    assert main(["stress", "solid_angle_cone", "d_beckmann"]) == 130
    said = capsys.readouterr()
    assert "interrupted after 1 of 2" in said.err and "1 functions" in said.out


def test_the_page_needs_nothing_else(tmp_path, capsys):
    assert main(["stress", "projected_solid_angle_disk_naive", "d_beckmann", "random_number", "-o", str(tmp_path)]) == 0
    page = (tmp_path / "index.html").read_text("utf-8")
    assert "http:" not in page and "https:" not in page and "<script" not in page and page.count("data:image/png") == 3
    assert {path.name for path in tmp_path.iterdir()} == {
        "index.html", "projected_solid_angle_disk_naive.png", "d_beckmann.png", "random_number.png"}
    assert "halfway eval projected_solid_angle_disk_naive radius=" in page


def test_a_map_shows_the_worst_of_each_cell():
    found = judged("projected_solid_angle_disk_naive")
    (radii, across), (heights, down) = (rungs(found.args[name]) for name in ("radius", "height"))
    picture = np.asarray(panel(found.errors, (radii, across), (heights, down)))
    i = int(np.argmax(found.errors))
    row, column = down[i], across[i]
    box = picture[9 * 18 * row // len(heights) + 2:9 * 18 * (row + 1) // len(heights) - 2,
                  9 * 18 * column // len(radii) + 2:9 * 18 * (column + 1) // len(radii) - 2].reshape(-1, 3)
    assert np.isinf(found.errors[i]) and np.any(np.all(box == FAULT, -1))
    assert heat_map(judged("solid_angle_cone")).height < 200


# --- scenes ----------------------------------------------------------------------------------------------------------
def test_a_scene_with_a_fault_is_told(monkeypatch, ctx):
    found = catalog.step("lights/distribution")
    assert played(found, ctx=ctx).faults == () and played(found, ctx=ctx).meant > 0
    monkeypatch.setattr("app.stress.scenes.is_meant", lambda found, values: False)
    bad = played(found, ctx=ctx).faults
    assert bad and "negative" in bad[0].words and bad[0].state.startswith("lights/distribution?")


@pytest.fixture(scope="module")
def players():
    """One stage a step, for as long as they are tried."""
    open_ones: dict[str, Player] = {}
    yield lambda found: open_ones.setdefault(found.id, Player(found))
    for player in open_ones.values():
        player.__exit__()


@settings(deadline=None, max_examples=200)
@given(states())
def test_no_state_has_a_fault(players, drawn):
    found, state = drawn
    assert players(found).fault(state.values) is None


@pytest.mark.parametrize("found", [f for f in catalog.steps() if f.step.scene.negative], ids=lambda found: found.id)
def test_where_negative_light_is_meant_there_is_some(found, ctx):
    """So that the exception does not outlive its reason."""
    rng, meant = np.random.default_rng(0), found.step.scene.negative
    assert set(meant) <= set(found.values)
    with Player(found, ctx) as player:
        assert any(negative(player, {name: at_random(rng, spec, meant.get(name)) for name, spec in
                                     found.values.items()}) for _ in range(60))


def at_random(rng, spec, ends):
    low, high = ends or (spec.low, spec.high)
    return int(rng.integers(low, high + 1)) if spec.quantity.kind == "int" else float(rng.uniform(low, high))


def negative(player: Player, values: dict) -> int:
    player.fault(values)
    return player.stage.picture.faults().negative
