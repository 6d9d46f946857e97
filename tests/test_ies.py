"""IES files: every branch of LM-63 is read as the standard says, the flux is exact, what is wrong is told in a line."""

import json
import re
import time

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from app.__main__ import main
from app.gpu.evaluate import evaluate
from app.ies import parse, read
from app.ies import text as ies_text
from app.optics.ies import (
    ies_as_spot,
    ies_candela,
    ies_flux,
    ies_place,
    ies_plane,
    ies_ring_flux,
    ies_solid,
    ies_towards,
)
from app.optics.spot import spot_flux
from app.problem import Problem
from app.tables import FOLDER, built_in, names
from app.tolerance import FACTOR, ratio

LABELS = "[TEST] 1\n[TESTLAB] x\n[ISSUEDATE] x\n[MANUFAC] x\n"


def file(vertical=(0, 45, 90), horizontal=(0,), candela=None, first="IESNA:LM-63-2002", ten=None, three="1 1 10",
         tilt="NONE", lumens=10000, kind=1, lamps=1, multiplier=1, labels=LABELS) -> str:
    if candela is None:
        candela = [[100 * (j + 1) * (i + 1) for i in range(len(vertical))] for j in range(len(horizontal))]
    ten = ten or f"{lamps} {lumens} {multiplier} {len(vertical)} {len(horizontal)} {kind} 2 0 0 0"
    rows = [" ".join(map(repr, row)) for row in (list(vertical), list(horizontal), *map(list, candela))]
    head = f"{first}\n" if first else ""
    return "\n".join([f"{head}{labels}TILT={tilt}", ten, three, *rows]) + "\n"


def at(found, theta, phi):
    return float(ies_candela(found.table, np.radians(theta), np.radians(phi)))


def told(text: str | bytes) -> str:
    with pytest.raises(Problem) as caught:
        parse(text.encode() if isinstance(text, str) else text, "a.ies")
    words = str(caught.value)
    assert "\n" not in words and words.endswith(".") and re.match(r"a\.ies, line \d+: ", words), words
    assert "LM-63" in words
    return words


# --- what is in a file -----------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("first", "year"), [
    ("IESNA91", 1991), ("IESNA:LM-63-1995", 1995), ("IESNA:LM-63-2002", 2002), ("IES:LM-63-2019", 2019),
    ("IESNA86", 1986), ("", 1986), ("  iesna:lm-63-2002  ", 2002)])
def test_the_first_line_is_the_standard(first, year):
    found = parse(file(first=first).encode(), "a.ies")
    assert found.standard == f"LM-63-{year}" and found.warnings == ()


@pytest.mark.parametrize(("first", "factor"), [("", 0.9 * 0.8), ("IESNA91", 0.9 * 0.8), ("IESNA:LM-63-1995", 0.9),
                                               ("IESNA:LM-63-2002", 0.9), ("IES:LM-63-2019", 0.9)])
def test_the_ballast_lamp_factor_ends_with_1991(first, factor):
    """Later the same place is kept for the future, and in 2019 it is the type of the file's making."""
    found = parse(file(first=first, three="0.9 0.8 10", multiplier=3).encode(), "a.ies")
    assert at(found, 0, 0) == pytest.approx(100 * 3 * factor, rel=1e-14)
    assert found.max_candela == pytest.approx(300 * 3 * factor, rel=1e-14)


def test_candela_are_multiplied_once():
    one, two = (parse(file(multiplier=m, lumens=10000).encode(), "a.ies") for m in (1, 2))
    assert two.integrated_lumens == pytest.approx(2 * one.integrated_lumens, rel=1e-14)


def test_declared_lumens_and_absolute_photometry():
    assert parse(file(lamps=3, lumens=1100).encode(), "a.ies").declared_lumens == 3300
    found = parse(file(lumens=-1).encode(), "a.ies")
    assert found.declared_lumens is None and np.isnan(found.table[0, 3]) and found.integrated_lumens > 0


@pytest.mark.parametrize("change", [
    lambda t: t.replace("\n", "\r\n"), lambda t: t.replace("\n", "\r"), lambda t: t + "\x1a",
    lambda t: t + "\r\n\x1a\0\0", lambda t: t.replace("TILT=", " tilt = "),
    lambda t: t.replace("1 10000 1 3 1 1 2 0 0 0", "1,10000,1\n\n3,1 1,\t2,0,0,0"),
    lambda t: t.replace("100 200 300", "100\n200\n300"), lambda t: t.replace("0 45 90", "0, 45., 9e1"),
    lambda t: "\ufeff" + t])
def test_tolerant_in_form(change):
    plain, changed = (parse(t.encode(), "a.ies") for t in (file(), change(file())))
    assert np.array_equal(plain.table, changed.table) and changed.warnings == ()


@pytest.mark.parametrize("code", ["cp1252", "latin-1", "utf-8", "utf-16"])
def test_letters_and_keywords(code):
    text = file(labels=LABELS + "[LUMINAIRE] Gehäuse\n[MORE] 25° geneigt\n[LAMP] x\n")
    found = parse(text.encode(code), "a.ies")
    assert found.keywords["LUMINAIRE"] == "Gehäuse\n25° geneigt" and found.title == "Gehäuse 25° geneigt"
    assert found.keywords["LAMP"] == "x"


def test_labels_of_1986_are_lines():
    found = parse(file(first="", labels="A lamp\nof mine\n").encode(), "a.ies")
    assert found.labels == ("A lamp", "of mine") and found.title == "A lamp" and found.keywords == {}


def test_required_keywords_are_missed_since_2002():
    (warning,) = parse(file(labels="[TEST] 1\n").encode(), "a.ies").warnings
    assert "[TESTLAB], [ISSUEDATE], [MANUFAC]" in warning
    assert parse(file(first="IESNA:LM-63-1995", labels="").encode(), "a.ies").warnings == ()


def test_tilt_include_is_read_and_not_applied():
    text = file(tilt="INCLUDE\n1\n3\n0 45 90\n1 .9 .8")
    found = parse(text.encode(), "a.ies")
    assert np.array_equal(found.table, parse(file().encode(), "a.ies").table) and "not applied" in found.warnings[0]


@pytest.mark.parametrize("there", [True, False])
def test_tilt_file_is_refused_by_name(tmp_path, there):
    path = tmp_path / "a.ies"
    path.write_text(file(tilt="lamp.tlt"))
    if there:
        (tmp_path / "lamp.tlt").write_text("1")
    with pytest.raises(Problem, match=f"line 6: TILT= names the file 'lamp.tlt', which "
                                      f"{'lies' if there else 'does not exist'} beside it"):
        read(path)


# --- directions ------------------------------------------------------------------------------------------------------
def test_axial():
    found = parse(file().encode(), "a.ies")
    assert found.symmetry == "axial" and {at(found, 45, phi) for phi in (-180, -7, 0, 100, 180)} == {200.0}
    assert at(found, 22.5, 3) == pytest.approx(150, rel=1e-14)
    assert at(found, 90, 0) == 300 and at(found, 90.01, 0) == 0 and at(found, 180, 0) == 0  # never measured: dark


@pytest.mark.parametrize(("horizontal", "symmetry", "first", "images"), [
    ((0, 45, 90), "quadrant", "IESNA:LM-63-2002", {0: 100, 45: 200, 90: 300, 135: 200, 180: 100, -45: 200, -90: 300}),
    ((0, 90, 180), "bilateral", "IESNA:LM-63-2002", {0: 100, 90: 200, 180: 300, -90: 200, -45: 150, 45: 150}),
    ((90, 180, 270), "bilateral 90-270", "IESNA:LM-63-1995", {90: 100, 180: 200, -90: 300, 0: 200, 45: 150, -45: 250}),
    ((0, 90, 180, 270, 360), "none", "IESNA:LM-63-2002", {90: 200, 180: 300, -90: 400, -45: 350}),
    ((0, 100, 200, 300, 360), "none", "IESNA:LM-63-2002", {100: 200, 180: 280, -180: 280, -160: 300, -60: 400}),
])
def test_symmetry_is_written_out(horizontal, symmetry, first, images):
    rows = [[10 * (j + 1) * 10] * 2 for j in range(len(horizontal))]
    if horizontal[-1] == 360:
        rows[-1] = rows[0]
        images = {k: v for k, v in images.items() if k != -45} | {-30: 250}
        images = images if horizontal[1] == 100 else {**images, -30: 200.0}
    found = parse(file((0, 90), horizontal, rows, first=first).encode(), "a.ies")
    assert found.symmetry == symmetry and found.warnings == ()
    for phi, value in images.items():
        assert at(found, 60, phi) == pytest.approx(mean_towards_pole(rows, horizontal, found, phi, value), rel=1e-12)


def mean_towards_pole(rows, horizontal, found, phi, value):
    """At theta = 0 all planes agree (their mean), at 90 each has its own value; 60 degrees is two thirds of the way."""
    return at(found, 0, 0) / 3 + value * 2 / 3


def test_planes_that_end_at_315_are_closed():
    rows = [[10.0 * j, 10.0 * j] for j in range(8)]
    found = parse(file((0, 90), tuple(range(0, 316, 45)), rows).encode(), "a.ies")
    assert at(found, 90, -22.5) == pytest.approx(35.0) and "end at 315" in found.warnings[0]
    closed = parse(file((0, 90), tuple(range(0, 361, 45)), [*rows, rows[0]]).encode(), "a.ies")
    assert np.array_equal(found.table, closed.table)


def test_no_plane_is_dropped_and_0_and_360_are_one():
    rows = [[100, 100], [200, 200], [300, 300]]
    found = parse(file((0, 90), (0, 180, 360), rows).encode(), "a.ies")
    assert at(found, 90, 0) == 200 and at(found, 90, 180) == 200  # 0 and 360 disagree: their mean, the same flux
    assert found.integrated_lumens == pytest.approx(2 * np.pi * 200, rel=1e-14)


def test_the_poles_are_one_direction_and_keep_the_flux():
    found = parse(file((0, 90), (0, 90), [[100, 0], [300, 0]]).encode(), "a.ies")
    assert {at(found, 0, phi) for phi in (0, 45, 90, -120)} == {200.0}


def test_type_a_stands_upright_and_looks_forward():
    """LM-63-2002: V -90 is straight down, V 0 H 0 the horizontal front, H runs clockwise."""
    rows = [[0, 1, 2], [0, 10, 3], [0, 5, 4]]
    found = parse(file((-90, 0, 90), (-90, 0, 90), rows, kind=3).encode(), "a.ies")
    assert at(found, 90, 0) == 10 and at(found, 90, -90) == pytest.approx(5) and at(found, 90, 90) == pytest.approx(1)
    assert at(found, 90, 180) == 0 and at(found, 0, 0) == 0


def test_type_b_turns_about_a_horizontal_axis():
    """LM-63-2002: V 0 H 0 is straight down, V 90 the horizontal front; the planes share a horizontal axis."""
    rows = [[0, 10, 6], [0, 4, 2], [0, 0, 0]]
    found = parse(file((-90, 0, 90), (0, 45, 90), rows, kind=2).encode(), "a.ies")
    assert at(found, 0, 0) == 10 and at(found, 90, 0) == pytest.approx(6) and at(found, 45, 90) == pytest.approx(4)
    assert at(found, 45, -90) == pytest.approx(4) and at(found, 45, 0) == pytest.approx(8) and at(found, 135, 0) == 0


@pytest.mark.parametrize("kind", [2, 3])
def test_a_and_b_have_the_flux_of_the_sphere(kind):
    """1 cd over the measured half: 2 pi lm; I = cos V or cos H against scipy."""
    ones = parse(file((-90, 0, 90), (-90, 0, 90), np.ones((3, 3)).tolist(), kind=kind).encode(), "a.ies")
    assert ones.integrated_lumens == pytest.approx(2 * np.pi, rel=1e-14)


# --- flux ------------------------------------------------------------------------------------------------------------
def test_the_flux_of_a_cosine_is_its_interpolants():
    """1000 cos theta at 5 degrees: 3139.60 lm is exact for the straight lines between the values; the smooth source has
    1000 pi = 3141.59 lm, and a trapezoid of I sin theta gives 3133.61."""
    t = np.radians(np.arange(0, 91, 5))
    candela = 1000 * np.cos(t)
    q = np.diff(candela) / np.diff(t)
    p = candela[:-1] - q * t[:-1]
    exact = 2 * np.pi * sum((-(p + q * x) * np.cos(x) + q * np.sin(x)) * s for x, s in ((t[1:], 1), (t[:-1], -1))).sum()
    found = parse(file(range(0, 91, 5), (0,), [candela.tolist()], lumens=3200).encode(), "a.ies").integrated_lumens
    assert exact == pytest.approx(3139.60, abs=0.005) and found == pytest.approx(exact, rel=1e-12)
    assert 1000 * np.pi == pytest.approx(3141.59, abs=0.005)
    assert 2 * np.pi * np.trapezoid(candela * np.sin(t), t) == pytest.approx(3133.61, abs=0.005)
    assert built_in("bare").integrated_lumens == pytest.approx(exact, rel=1e-10)


def test_the_error_of_the_interpolant_falls_as_the_square():
    errors = []
    for step in (10, 5, 2.5):
        t = np.arange(0, 90.1, step)
        candela = np.abs(1000 * np.cos(np.radians(t))).tolist()
        found = parse(file(t.tolist(), (0,), [candela], lumens=-1).encode(), "a.ies")
        errors.append(1000 * np.pi - found.integrated_lumens)
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.02) and errors[1] / errors[2] == pytest.approx(4, rel=0.02)


@pytest.mark.parametrize("name", names())
def test_the_flux_by_a_second_method(name):
    """A sum over a fine grid of directions, which knows nothing of the file's own angles."""
    table = built_in(name).table
    theta, phi = (np.arange(n) + 0.5 for n in (1440, 1440))
    theta, phi = np.pi * theta / 1440, 2 * np.pi * phi / 1440 - np.pi
    sum_ = np.sum(ies_candela(table, theta[:, None], phi) * np.sin(theta)[:, None]) * 2 * (np.pi / 1440) ** 2
    assert sum_ == pytest.approx(ies_flux(table), rel=1e-4)


def test_a_ring_by_quadrature():
    for theta, width, below, above in ((0.7, 0.4, 3.0, 5.0), (1.57, 3.1, 1.0, 2.0), (0.01, 0.02, 9.0, 1.0)):
        low, high = theta - width / 2, theta + width / 2
        value, _ = quad(lambda t, low=low, w=width, b=below, c=above: 2 * np.pi * np.sin(t)
                        * (b + (c - b) * (t - low) / w), low, high, epsabs=0, epsrel=1e-13)
        assert ies_ring_flux(theta, width, below, above) == pytest.approx(value, rel=1e-13)


def test_places_solids_planes_and_aims():
    table = built_in("downlight").table
    places = [[0, 1, 0], [1, 1, 0], [1, 0.5, 0.5], [17, 0, 1], [-1, 0, 0], [-1, 0, 0]]
    assert ies_place(table, 1, [0, 5, 7.5, 90, 91, -1]).tolist() == places
    assert ies_solid(table, 0.3, 0.0).tolist() == pytest.approx([0, 0, -1], abs=1e-15)
    either = [at(built_in("downlight"), np.degrees(0.3), 9)] * 2
    assert ies_plane(table, [-0.3, 0.3], 0.2).tolist() == pytest.approx(either)
    aimed = ies_towards(table, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0.0, np.pi / 2], np.pi / 2)
    assert aimed.tolist() == pytest.approx([built_in("downlight").max_candela] * 2)


@pytest.mark.parametrize(("hotspot", "falloff"), [(18, 30), (30, 30), (40, 25)])
def test_a_spot_and_a_luminaire_of_the_same_flux(hotspot, falloff):
    table, (h, f) = built_in("downlight").table, np.radians([hotspot, falloff])
    theta = np.linspace(0, np.pi / 2, 100_001)
    share = ies_as_spot(table, theta, h, f)
    flux = 2 * np.pi * np.trapezoid(share * np.sin(theta), theta)
    assert flux == pytest.approx(spot_flux(1.0, h, f), rel=1e-8)


@pytest.mark.parametrize("name", names())
def test_the_gpu_agrees_for_every_luminaire(name, ctx):
    rng, table = np.random.default_rng(3), built_in(name).table.astype(np.float32).astype(float)
    theta, phi = (rng.uniform(low, np.pi, 2000).astype(np.float32).astype(float) for low in (0, -np.pi))
    args = {"table": table, "theta": theta, "phi": phi}
    assert ratio("ies_candela", args, evaluate("ies_candela", args, ctx=ctx)).max() <= FACTOR
    flux = {"table": table}
    assert ratio("ies_flux", flux, evaluate("ies_flux", flux, ctx=ctx)) <= FACTOR


# --- the files of the course -----------------------------------------------------------------------------------------
def test_the_shipped_files_cover_every_branch():
    found = [built_in(name) for name in names()]
    assert {f.year for f in found} == {1986, 1991, 1995, 2002, 2019} and {f.kind for f in found} == {"A", "B", "C"}
    assert {f.symmetry for f in found} == {"axial", "quadrant", "bilateral", "bilateral 90-270", "none"}
    assert {f.tilt for f in found} == {"NONE", "INCLUDE"} and {f.units for f in found} == {1, 2}
    assert any(f.declared_lumens is None for f in found) and any(f.lamps > 1 for f in found)
    assert {(f.vertical[0], f.vertical[-1]) for f in found if f.kind == "C"} == {(0, 90), (90, 180), (0, 180)}
    for f in found:
        text = (FOLDER / f.name.rpartition("/")[2]).read_bytes().decode("cp1252")
        assert "Covers:" in text and "Halfway" in text
    raw = (FOLDER / "spots.ies").read_bytes()
    assert b"\r\n" in raw and raw.endswith(b"\x1a") and b"," in raw and b"\xe4" in raw


def test_only_the_bare_lamp_emits_more_than_it_declares():
    for name in names():
        found = built_in(name)
        if found.declared_lumens:
            assert (found.integrated_lumens > found.declared_lumens) == (name == "bare")
    assert "1000 lm are declared, and the candela add up to 3139.6 lm" in built_in("bare").warnings[0]


# --- what is wrong is told -------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("text", "line", "words"), [
    (file(candela=[[1, 2]]), 10, "the file ends after 2 of 3 candela values"),
    (file()[:40], 3, "no line begins with TILT="),
    (file().replace("100 200 300", "100 200 300 400"), 10, "so a count is wrong"),
    (file().replace("1 10000 1 3 1", "1 10000 1 3 2"), 10, "no number|horizontal angle|ends after|ascending"),
    (file().replace("1 10000 1 3 1", "1 10000 1 2 1"), 9, ""),
    (file().replace("1 10000 1 3 1", "1 10000 1 3.5 1"), 7, "vertical angles is 3.5"),
    (file().replace("1 10000 1 3 1", "1 10000 1 -3 1"), 7, "vertical angles is -3"),
    (file().replace("1 10000 1 3 1", "1 10000 1 3000 3000"), 7, "3000 x 3000 angles"),
    (file().replace("1 10000 1 3 1", "1 10000 1 9999999 1"), 7, "from 2 to 3601"),
    (file((0, 90, 45)), 9, "45 among the vertical angles comes after 90"),
    (file((0, 45, 45)), 9, "45 among the vertical angles repeats the one before"),
    (file((0, 90), (0, 90, 90)), 10, "repeats"),
    (file((0, 45, 200)), 9, "the vertical angle 200 lies outside 0 to 180"),
    (file((0, 90), (0, 45, 200)), 10, "the horizontal angles end at 200"),
    (file((0, 90), (10, 90)), 10, "the first horizontal angle is 10"),
    (file(kind=2), 10, "0 to 90"),
    (file(candela=[[1, -2, 3]]), 11, "the candela value -2 is negative"),
    (file().replace("100 200", "100 nan"), 11, "'nan' among the candela values is no number"),
    (file().replace("100 200", "100 inf"), 11, "'inf' among"),
    (file().replace("100 200", "100 2oo"), 11, "'2oo' among"),
    (file(candela=[[0, 0, 0]]), 11, "all candela are 0"),
    (file(lumens=-5), 7, "lumens per lamp is -5"),
    (file(multiplier=0), 7, "multiplier is 0"),
    (file(kind=4), 7, "photometric type is 4"),
    (file(three="0 1 10"), 8, "ballast factor is 0"),
    (file(first="IESNA91", three="1 0 10"), 8, "ballast-lamp factor is 0"),
    (file(tilt="INCLUDE\n9\n1\n0\n1"), 7, "geometry is 9"),
    (file(tilt="INCLUDE\n1\n2\n0 45\n1 -1"), 10, "tilt factor is negative"),
    (file(tilt=""), 6, "TILT= names nothing"),
    ("", 1, "empty"), ("\r\n \x1a", 1, "empty"),
    ("x" * 10_000_000, 1, "no line begins with TILT="),
    ("hello\n" * 1_700_000, 1_700_000, "no line begins with TILT="),
    (file() + "7 " * 5_000_000, 12, "so a count is wrong"),
])
def test_a_complaint_names_the_line_and_the_rule(text, line, words):
    said = told(text)
    assert re.search(words, said), said
    if line not in (10, 9) or words:
        number = int(re.match(r"a\.ies, line (\d+)", said)[1])
        assert abs(number - line) <= 1, said


def test_binary_rubbish_is_told():
    assert "is no text" in told(np.random.default_rng(1).bytes(4000))
    assert "is no text" in told(b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 10)


def test_a_file_that_cannot_be_read(tmp_path, monkeypatch):
    for path, words in ((tmp_path / "none.ies", "There is no file"), (tmp_path, "is a folder")):
        with pytest.raises(Problem, match=words):
            read(path)
    path = tmp_path / "a.ies"
    path.write_text(file())
    monkeypatch.setattr(ies_text, "BYTES", 10)
    with pytest.raises(Problem, match="the limit is"):
        read(path)
    monkeypatch.undo()

    def forbidden(_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.read_bytes", forbidden)
    with pytest.raises(Problem, match="may not be read"):
        read(path)


def test_what_is_odd_is_remarked_on():
    odd = {"IESNA:LM-63-1999": file(first="IESNA:LM-63-1999"), "go from 0 to 85": file((0, 40, 85)),
           "only horizontal angle is 45": file(horizontal=(45,)), "are of LM-63-1995": file((0, 90), (90, 270)),
           "continues no keyword": file(labels="[MORE] a\n" + LABELS), "ignored": file() + "END\n",
           "0 lumens per lamp": file(lumens=0), "are declared": file(lumens=1)}
    for words, text in odd.items():
        found = parse(text.encode(), "a.ies")
        assert any(words in warning and re.match(r"a\.ies, line \d+: ", warning) for warning in found.warnings), words


@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.data())
def test_damage_anywhere_is_a_luminaire_or_a_sentence(data):
    source = (FOLDER / f"{data.draw(st.sampled_from(names()))}.ies").read_bytes()
    content = bytearray(source)
    for _ in range(data.draw(st.integers(1, 3))):
        at_ = data.draw(st.integers(0, len(content)))
        scratch = data.draw(st.one_of(st.binary(max_size=6), st.sampled_from(
            [b" ", b"\n", b",", b"-1 ", b"nan ", b"1e999 ", b"0 ", b"TILT=", b"9" * 30, b"_1", b"\x1a"])))
        content[at_:at_ + data.draw(st.integers(0, 8))] = scratch
    if data.draw(st.booleans()):
        del content[data.draw(st.integers(0, len(content))):]
    whole_or_told(bytes(content))


@settings(max_examples=200, deadline=None)
@given(st.one_of(st.binary(max_size=300), st.text(max_size=200).map(str.encode),
                 st.lists(st.floats().map(repr), max_size=30).map(lambda x: ("TILT=NONE\n" + " ".join(x)).encode())))
@example(b"TILT=NONE\n1 1e308 1e308 2 1 1 2 0 0 0 1 1 1 0 90 0 1e308 1e308")
def test_anything_is_a_luminaire_or_a_sentence(content):
    whole_or_told(content)


def whole_or_told(content: bytes) -> None:
    try:
        found = parse(content, "a.ies")
    except Problem as problem:
        assert re.match(r"a\.ies, line \d+: ", str(problem)) and "\n" not in str(problem)
    else:
        assert np.isfinite(found.candela).all() and (found.candela >= 0).all() and np.isfinite(found.integrated_lumens)
        assert np.isfinite(np.delete(found.table, 3, 1)).all()


# --- the command -----------------------------------------------------------------------------------------------------
def test_the_command_speaks_json(capsys):
    assert main(["ies", str(FOLDER / "headlamp.ies"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["standard"] == "LM-63-2019" and found["photometric_type"] == "A" and found["symmetry"] == "none"
    assert found["declared_lumens"] is None and found["integrated_lumens"] == built_in("headlamp").integrated_lumens
    assert found["max_candela"] == 13816 and found["warnings"] == []
    assert found["vertical_angles"][0] == found["horizontal_angles"][0] == -90


def test_the_command_speaks_words(capsys):
    assert main(["ies", str(FOLDER / "bare.ies")]) == 0
    said = capsys.readouterr()
    assert "3139.6 lm" in said.out and "1000 lm of 1 lamp; 314.0% of them" in said.out and "are declared" in said.err
    assert main(["ies", str(FOLDER / "headlamp.ies")]) == 0
    assert "absolute photometry" in capsys.readouterr().out
    assert main(["ies", "none.ies"]) == 1
    assert capsys.readouterr().err == "halfway: There is no file none.ies; give the path of an IES file (LM-63).\n"


@pytest.mark.parametrize(("name", "theme"), [("street_light", "dark"), ("flood", "light"), ("headlamp", "projector")])
def test_a_report_has_its_four_parts(tmp_path, name, theme, ctx):
    from PIL import Image

    path = tmp_path / "report.png"
    assert main(["ies", str(FOLDER / f"{name}.ies"), "-o", str(path), "--theme", theme, "--size", "960x600"]) == 0
    picture = np.asarray(Image.open(path).convert("RGB")).astype(int)
    assert picture.shape == (600, 960, 3)
    back = picture[-1, -1]
    for part in (picture[90:320, :520], picture[90:320, 540:], picture[340:, :520], picture[340:, 540:]):
        assert np.count_nonzero(np.abs(part - back).max(-1) > 60) > 500


def test_reports_that_cannot_be_written(tmp_path):
    good = str(FOLDER / "bare.ies")
    assert main(["ies", good, "-o", str(tmp_path / "a.jpg")]) == 2
    assert main(["ies", good, "-o", str(tmp_path / "a.png"), "--theme", "pink"]) == 2


# --- the step --------------------------------------------------------------------------------------------------------
def test_the_words_of_the_step_are_true():
    from app.catalog import step

    words = step("lights/ies").step
    said = " ".join((words.notes + words.honesty + words.ask.told + words.ask.question).split())
    assert "3139.60 lm" in said and "1000π = 3141.59 lm" in said and "3140: about π times" in said
    assert built_in("bare").integrated_lumens == pytest.approx(3139.60, abs=0.005)
    assert "12 566" in said and 4000 * np.pi == pytest.approx(12566, abs=0.5)
    for name in ("downlight", "wall_washer", "street_light", "flood", "uplight"):
        found = built_in(name)
        assert 0.15 < 1 - found.integrated_lumens / found.declared_lumens < 0.3  # a fifth or so stays in the luminaire


def test_the_room_obeys_the_inverse_square_and_the_cosine():
    from app.optics.ies import ies_room_illuminance as room

    table = built_in("bare").table
    assert room(table, 2.0, 1.5, 0.0, 0.0, 0.0, -1.5) == pytest.approx(1000 / 4, rel=1e-12)  # under it
    slant = 1000 * np.cos(np.pi / 4) * np.cos(np.pi / 4) / (2 * 2.0**2)
    assert room(table, 2.0, 2.0, 0.0, 0.0, 2.0, -2.0) == pytest.approx(slant, rel=3e-3)  # 1000 cos, in straight lines
    assert room(table, 1.0, 1.0, 0.0, 0.0, 0.0, 1.5) == 0.0  # above a lamp that shines down
    assert room(table, 1.5, 2.0, 0.0, np.pi / 2, 0.0, 1.5) == pytest.approx(1000 / 4, rel=1e-12)  # aimed at the wall


def test_a_file_of_the_users_lights_the_step(tmp_path, ctx):
    from PIL import Image

    path = tmp_path / "mine.ies"
    path.write_text(file((0, 30, 60, 90), (0,), [[900, 500, 50, 0]]))
    pictures = []
    for more in ([], ["--ies", str(path)]):
        out = tmp_path / "a.png"
        assert main(["render", "lights/ies", "-o", str(out), "--size", "320x240", *more]) == 0
        pictures.append(np.asarray(Image.open(out).convert("RGB")).astype(int))
    assert np.abs(pictures[0] - pictures[1]).max() > 60
    assert main(["render", "solid_angle/cone", "-o", str(out), "--ies", str(path)]) == 2


def test_a_large_file_is_read(record_property):
    rng = np.random.default_rng(0)
    rows = rng.uniform(0, 1000, (361, 181)).round(2)
    text = file(range(181), range(361), rows.tolist(), lumens=-1).encode()
    start = time.perf_counter()
    found = parse(text, "a.ies")
    record_property("ms", 1e3 * (time.perf_counter() - start))
    assert found.candela.shape == (361, 181) and found.integrated_lumens > 0
