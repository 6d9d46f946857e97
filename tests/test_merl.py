"""Measured reflectance: MERL's format is read or refused, indexed as its authors do, judged, and fitted."""

import json
import math

import numpy as np
import pytest

from app.__main__ import main
from app.board import merl
from app.board.coated import Coated
from app.board.fit import fit, in_square
from app.board.merl import CELLS, SCALES, SHAPE, coordinates, directions, middles, read
from app.gpu.evaluate import evaluate
from app.hemisphere import NORMAL
from app.optics.cook_torrance import brdf_cook_torrance
from app.optics.spherical import direction
from app.problem import Problem

M, RHO, F0 = 0.15, np.array([0.4, 0.2, 0.05]), np.array([0.05, 0.3, 0.9])


def coated(n, l, v) -> np.ndarray:
    return np.stack([RHO[i] / np.pi + brdf_cook_torrance(n, l, v, M, F0[i]) for i in range(3)])


def stored(f: np.ndarray) -> np.ndarray:
    return (f / np.reshape(SCALES, (3, 1, 1, 1))).astype("<f8")


def write(path, cells: np.ndarray):
    path.write_bytes(np.array(SHAPE, "<i4").tobytes() + cells.astype("<f8").tobytes())
    return path


@pytest.fixture(scope="module")
def made_up() -> np.ndarray:
    """Numbers as a file holds them; -1 where light or eye is below the horizon, as in the database."""
    l, v = directions(*middles())
    return np.where((l[..., 2] > 0) & (v[..., 2] > 0), stored(coated(NORMAL, l, v)), -1.0)


@pytest.fixture(scope="module")
def measured(tmp_path_factory, made_up):
    return read(write(tmp_path_factory.mktemp("merl") / "made-up.binary", made_up))


def pairs(count: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    return tuple(direction(np.arccos(random.uniform(0.2, 1, count)),  # type: ignore[return-value]
                           random.uniform(-np.pi, np.pi, count)) for _ in range(2))


# --- the format ------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("spoil", "said"), [
    (lambda raw: raw[:-8], "is cut off: it has 34992004 bytes"),
    (lambda raw: raw + b"\0", "goes on after its end"),
    (lambda raw: np.array([90, 90, 360], "<i4").tobytes() + raw[12:], "begins with 90 x 90 x 360"),
    (lambda raw: b"", "has 0 bytes"),
    (lambda raw: raw[:12 + 8 * 5] + np.array(np.nan).tobytes() + raw[12 + 8 * 6:], "number 6 of red is no number"),
    (lambda raw: raw[:-8] + np.array(np.inf).tobytes(), f"number {CELLS} of blue"),
], ids=["cut off", "too long", "other counts", "empty", "NaN", "infinite"])
def test_what_is_no_measurement_is_refused(tmp_path, made_up, spoil, said):
    path = tmp_path / "x.binary"
    path.write_bytes(spoil(np.array(SHAPE, "<i4").tobytes() + made_up.tobytes()))
    with pytest.raises(Problem, match=r"x\.binary") as caught:
        read(path)
    assert said in str(caught.value) and "\n" not in str(caught.value)
    with pytest.raises(Problem, match="No such file"):
        read(tmp_path / "none.binary")


def by_the_database(l, v) -> int:
    """The cell of a pair as the database's reader has it: rotate both so that h is the pole, then floor."""
    h = (l + v) / np.linalg.norm(l + v)
    theta, phi = math.acos(h[2]), math.atan2(h[1], h[0])
    x, y, z = l
    x, y = x * math.cos(phi) + y * math.sin(phi), y * math.cos(phi) - x * math.sin(phi)
    x, z = x * math.cos(theta) - z * math.sin(theta), z * math.cos(theta) + x * math.sin(theta)
    theta_d, phi_d = math.acos(min(z, 1.0)), math.atan2(y, x)
    phi_d += math.pi * (phi_d < 0)
    index_h = int(math.sqrt(math.degrees(theta) / 90) * 90)
    return min(int(phi_d / math.pi * 180), 179) + 180 * (int(math.degrees(theta_d)) + 90 * index_h)


def test_a_direction_falls_into_the_databases_cell():
    numbers = np.arange(CELLS, dtype="<f8").reshape(SHAPE)
    here = merl.Merl("x", np.stack([numbers] * 3))
    index = np.random.default_rng(2).integers(0, (88, 88, 178), (400, 3)) + 1
    l, v = directions(*(middle[tuple(index.T)] for middle in middles()))
    above = (l[:, 2] > 0.01) & (v[:, 2] > 0.01)
    l, v, index = l[above], v[above], index[above]
    assert len(l) > 100
    turn = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])  # isotropic: what counts is between them
    flat = np.ravel_multi_index(tuple(index.T), SHAPE)
    np.testing.assert_allclose(here.value(NORMAL, l @ turn.T, v @ turn.T, 0) / SCALES[0], flat, rtol=0, atol=1e-3)
    assert [by_the_database(*pair) for pair in zip(l, v, strict=True)] == flat.tolist()


def test_the_coordinates_are_taken_apart_and_put_together():
    theta_h, theta_d, phi_d = middles((7, 7, 13))
    l, v = directions(theta_h, theta_d, phi_d)
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    for found, given in zip(coordinates(turn @ NORMAL, l @ turn.T, v @ turn.T), (theta_h, theta_d, phi_d), strict=True):
        np.testing.assert_allclose(found, given, atol=1e-11)


def test_each_colour_has_its_scale(measured):
    l, v = directions(0.1, 0.4, 1.0)
    found = measured.rgb(NORMAL, l, v)
    np.testing.assert_allclose(found, coated(NORMAL, l, v), rtol=2e-3)
    np.testing.assert_allclose(merl.Merl("x", np.ones((3, *SHAPE))).rgb(NORMAL, l, v),
                               [1 / 1500, 1.15 / 1500, 1.66 / 1500])


def test_between_the_cells_it_is_the_model_it_was_made_of(measured):
    """To (width of a cell)^2 f'' / 8: worst on the flank of the lobe, where f falls by a third over a cell of 1 degree
    and is yet as much as rho / pi."""
    l, v = pairs(4000)
    model = coated(NORMAL, l, v)
    off = abs(np.moveaxis(measured.rgb(NORMAL, l, v), -1, 0) / model - 1)
    assert off.max() < 0.04 and np.median(off) < 2e-3


def test_light_and_eye_can_be_swapped(measured):
    l, v = pairs(500)
    np.testing.assert_allclose(measured.rgb(NORMAL, l, v), measured.rgb(NORMAL, v, l), rtol=1e-9)


# --- what is missing -------------------------------------------------------------------------------------------------
def test_the_scene_reads_the_same_numbers(measured):
    """float32 and between the same cells; where half a cell was not measured, too."""
    text = ('#include "display/merl.glsl"\n'
            "vec3 value_of(sampler2D cells, vec3 n, vec3 l, vec3 v) { return merl_value(cells, n, l, v); }")
    n = NORMAL
    for l, v in (pairs(60), (direction(0.3, np.linspace(-3, 3, 20)), direction(0.3, np.linspace(-3, 3, 20))),
                 (direction(0.4, 0.0)[None], direction(0.4, np.pi)[None])):
        got = evaluate("value_of", {"cells": measured.table, "n": n, "l": l, "v": v}, text)
        np.testing.assert_allclose(got, measured.rgb(n, l, v), rtol=5e-3, atol=1e-5)


def test_what_was_not_measured_is_no_number_and_no_fault(made_up):
    cells = made_up.copy()
    cells[:, :, 80:] = -1.0  # theta_d from 80 degrees
    here = merl.Merl("x", cells)
    l, v = direction(np.radians(84), np.pi), direction(np.radians(84), 0.0)
    assert np.isnan(here.rgb(NORMAL, l, v)).all()
    assert np.isfinite(here.rgb(NORMAL, *directions(0.1, np.radians(79.9), 1.0))).all()  # its own cell counts, alone
    np.testing.assert_array_equal(here.rgb(NORMAL, l, -v), 0)  # below the horizon there is nothing to measure
    badges = here.badges()
    assert badges["finite"].ok and badges["non_negative"].ok and badges["reciprocal"].ok
    above = made_up[0] >= 0
    assert here.missing == pytest.approx(above[:, 80:].sum() / above.sum(), rel=1e-12)
    assert "not measured" in here.warnings[0]


def test_the_badges_of_a_measurement(measured):
    assert measured.missing == 0 and measured.warnings == ()
    badges, model = measured.badges(), Coated(of=fit(measured)).badges()
    assert badges["reciprocal"].ok and badges["non_negative"].ok and badges["finite"].ok
    assert badges["energy"].worst == pytest.approx(model["energy"].worst, rel=0.02)


# --- the fit ---------------------------------------------------------------------------------------------------------
def test_the_fit_finds_what_the_data_were_made_of(measured):
    found = fit(measured)
    assert found.m == pytest.approx(M, rel=1e-6)
    np.testing.assert_allclose(found.rho, RHO, rtol=1e-6)
    np.testing.assert_allclose(found.f0, F0, rtol=1e-6)
    assert found.residual < 1e-6


def test_the_fit_of_noisy_data(made_up):
    noise = 1 + 0.1 * np.random.default_rng(4).normal(size=made_up.shape)
    found = fit(merl.Merl("x", made_up * noise))
    assert found.m == pytest.approx(M, rel=2e-3)
    np.testing.assert_allclose(found.rho, RHO, rtol=0.02)
    np.testing.assert_allclose(found.f0, F0, rtol=0.02)
    assert found.residual == pytest.approx(0.1, rel=0.05)  # what is left is the noise


def test_a_fit_stays_in_range():
    bright = merl.Merl("x", stored(np.full((3, *SHAPE), 3 / np.pi)))
    found = fit(bright)
    assert all(0 <= x <= 1 for x in (*found.rho, *found.f0)) and max(found.rho) == 1 and found.residual > 0.2
    with pytest.raises(Problem, match="nothing was measured"):
        fit(merl.Merl("x", np.full((3, *SHAPE), -1.0)))


@pytest.mark.parametrize("seed", range(8))
def test_two_unknowns_in_a_square(seed):
    """Against a dense search of the square."""
    random = np.random.default_rng(seed)
    a, b, y = random.normal(size=(3, 20)) * [[1], [1], [2]]
    weight = random.uniform(size=20)
    p, q = in_square(a, b, y, weight)
    s, t = np.meshgrid(*[np.linspace(0, 1, 401)] * 2)
    error = np.sum(weight * (s[..., None] * a + t[..., None] * b - y) ** 2, -1)
    least = np.sum(weight * (p * a + q * b - y) ** 2)
    assert least <= error.min() + 1e-12 and error.min() - least < 1e-3


def test_the_command_tells_the_fit(measured, capsys):
    assert main(["board", measured.path, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["name"] == "made-up" and found["parameters"] == [] and found["missing"] == 0
    assert found["fit"]["m"] == pytest.approx(M) and found["badges"]["energy"]["worst"] < 1.1
    assert main(["board", measured.path, "--text"]) == 0
    assert "nearest rho / pi + Cook-Torrance: m 0.15, rho 0.4 0.2 0.05, f0 0.05 0.3 0.9" in capsys.readouterr().out


def test_a_folder_goes_on_after_a_file_that_cannot_be_read(tmp_path, capsys):
    good = "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(0.1); }"
    (tmp_path / "a.brdf").write_text("nonsense\n")
    (tmp_path / "b.brdf").write_text(f"analytic\n::begin shader\n{good}\n::end shader\n")
    (tmp_path / "c.binary").write_bytes(b"short")
    assert main(["board", str(tmp_path), "--json"]) == 0
    said = capsys.readouterr()
    assert [one["name"] for one in json.loads(said.out)] == ["b"]
    assert "a.brdf, line 1" in said.err and "c.binary has 5 bytes" in said.err
    (tmp_path / "b.brdf").unlink()
    assert main(["board", str(tmp_path), "--json"]) == 1
