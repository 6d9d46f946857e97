"""The unit ledger: dimensions by pint, the balance by integration, and what a wrong row is told."""

import numpy as np
import pytest

from app import catalog, ledger
from app.lesson import Ledger, LedgerRow, Term
from app.optics import twin
from app.plots import picture
from app.problem import Problem
from app.state import defaults
from app.theme import THEMES

STEPS = {found.id: found for found in catalog.steps() if isinstance(found.step.plot, Ledger)}
BULB = STEPS["radiometry/ledger"]
VALUES = defaults(BULB)


def plot(found) -> Ledger:
    assert isinstance(found.step.plot, Ledger)
    return found.step.plot


@pytest.mark.parametrize("found", STEPS.values(), ids=lambda found: found.id)
def test_every_row_follows_from_the_one_before(found):
    assert list(ledger.faults(plot(found))) == []
    for column in plot(found).columns:
        for row in column:
            assert "[" in str(ledger.dimension(row.unit))


def test_the_chains_go_through_the_units_of_the_deck():
    seen, energy = ([row.unit for row in column] for column in plot(BULB).columns)
    assert seen == ["W", "lm", "cd", "lx", "cd/m^2"]
    assert energy == ["W", "W", "W/sr", "W/m^2", "W/(m^2 sr)"]


def test_lumens_are_not_candela():
    """pint's own registry has no dimension for the solid angle; ours must."""
    assert ledger.dimension("lm") != ledger.dimension("cd") == ledger.dimension("lm/sr")
    assert ledger.dimension("lx") == ledger.dimension("lm/m^2") != ledger.dimension("cd/m^2")
    assert ledger.dimension("W/(m^2 sr)") == ledger.dimension("J/(s m^2 sr)") != ledger.dimension("W/m^2")


def wrong(unit: str, by: str) -> Ledger:
    rows = (LedgerRow("flux", Term("luminous_flux_source"), "lm"),
            LedgerRow("intensity", Term("bulb_luminous_intensity"), unit, by))
    return Ledger("Wrong", (rows,))


@pytest.mark.parametrize(("unit", "by", "said"), [
    ("cd", "1/m^2", "intensity: lm times 1/m^2 has the dimension"),
    ("lx", "1/sr", "and lx has [luminosity]"),
    ("cd", "", "lm times a number"),
    ("candles", "1/sr", "'candles' is no unit of the ledger"),
])
def test_a_wrong_row_is_told(unit, by, said):
    (word, sentence), = ledger.faults(wrong(unit, by))
    assert word == "intensity" and said in sentence and "\n" not in sentence


def test_a_unit_that_cannot_be_read():
    for unit in ("W/", "((", "W/(m^2", "1e"):
        with pytest.raises(Problem, match="no unit of the ledger"):
            ledger.dimension(unit)


def test_the_decks_example_line_by_line():
    lines = ledger.lines(plot(BULB).columns[0], VALUES)
    assert [line.value for line in lines] == pytest.approx([100, 3000, 238.732414637843, 38.19718634205488,
                                                            0.8 * 38.19718634205488 / np.pi], rel=1e-14)
    words = [ledger.factor_words(line) for line in lines]
    assert words == ["", "× 30.0 lm/W", "÷ 12.6 sr", "× 0.160 sr/m²", "÷ 3.93 sr"]
    assert lines[2].factor == pytest.approx(1 / (4 * np.pi)) and lines[3].factor == pytest.approx(1 / 2.5**2)


def test_a_lamp_that_gives_nothing_has_no_factor():
    lines = ledger.lines(plot(BULB).columns[0], VALUES | {"source_efficacy": 0.0})
    assert lines[1].value == 0 and lines[2].factor is None and ledger.factor_words(lines[2]) == ""
    dark = ledger.balance(plot(BULB), VALUES | {"source_efficacy": 0.0})
    assert dark is not None and dark.off == 0 == dark.emitted


@pytest.mark.parametrize("radius", [0.01, 0.3, 1.5, 2.0, 1000.0])
@pytest.mark.parametrize("distance", [0.01, 0.5, 2.5])
def test_emitted_is_received_and_escaped(radius, distance):
    found = ledger.balance(plot(BULB), VALUES | {"radius": radius, "distance": distance})
    assert found is not None and abs(found.off) < 2e-14
    share = twin("solid_angle_disk_on_axis")(radius, distance) / (4 * np.pi)  # a third way
    assert found.received == pytest.approx(3000 * share, rel=1e-10)


def test_the_picture_has_all_of_it():
    for theme in THEMES.values():
        drawn = picture(plot(BULB), VALUES, (520, 520), theme)
        assert drawn.shape == (520, 520, 3)
        rows = np.any(np.abs(drawn.astype(int) - drawn[-1, 0]) > 40, axis=(1, 2))
        assert rows.mean() > 0.6, "it is not empty"
        more = picture(plot(BULB), VALUES | {"distance": 1.0}, (520, 520), theme)
        assert np.any(more != drawn), "it follows the values"
    assert picture(plot(BULB), VALUES, (240, 240), THEMES["dark"]).shape == (240, 240, 3)


def test_the_validator_reads_the_ledger(tmp_path):
    from app.validation import validate

    source = BULB.loaded.source.replace('"lx", "sr/m^2"', '"lx", "1/m^2"')
    path = tmp_path / "ch02_radiometry.py"
    path.write_text(source, encoding="utf-8")
    told = validate(catalog.load(path))
    assert len(told) == 1 and "illuminance: cd times 1/m^2" in told[0] and ", line " in told[0]
