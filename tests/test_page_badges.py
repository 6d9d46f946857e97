"""Badges in pages: the verdicts of float32 GLSL in a real browser are the desktop's of float64, at any values."""

import os

import numpy as np
import pytest

from app.badges import of_model, told
from app.catalog import steps
from app.export.web.command import export
from app.export.web.judged import model_values
from app.export.web.page import file_of
from app.state import defaults
from tests.browser import CHROMIUM, opened, settle

pytestmark = pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
JUDGED = [found for found in steps() if found.step.models]
ALBEDO = 1.5e-3  # how far the page's largest albedo may be from the desktop's, in parts of it
ASK = """async values => {
    const {badges} = halfway, all = {...halfway.values, ...values}, found = [];
    for (const model of badges.models) {
        const judged = await badges.check(model, badges.asking(model, all, () => true));
        found.push(Object.entries(judged).map(([name, one]) => ({name, ...one, told: badges.told(name, one)})));
    }
    return found;
}"""


def states(found) -> list[dict]:
    """The first values, then two anywhere and one at an end of each that the badges depend on."""
    rng, first = np.random.default_rng(8), defaults(found)
    names = dict.fromkeys(name for model in found.step.models for name in model_values(model) if name in first)
    every = [{}]
    for i in range(3):
        every.append({name: value(found.values[name], rng.uniform() if i < 2 else rng.integers(2)) for name in names})
    return every


def value(spec, place: float):
    if spec.quantity.kind == "int":
        return round(spec.low + place * (spec.high - spec.low))
    return float(spec.low * (spec.high / spec.low) ** place if spec.scale == "log" else
                 spec.low + place * (spec.high - spec.low))


@pytest.mark.parametrize("found", JUDGED, ids=lambda found: found.id)
def test_verdicts_are_the_desktops(found, browser, tmp_path):
    export(found, tmp_path, poster=False)
    with opened(browser, tmp_path / file_of(found.id), (260, 200)) as (tab, heard):
        settle(tab)
        for state in states(found):
            for model, judged in zip(found.step.models, tab.evaluate(ASK, state), strict=True):
                wanted = of_model(model, {**defaults(found), **state})
                assert {one["name"]: one["ok"] for one in judged} == {name: b.ok for name, b in wanted.items()}, state
                for one in judged:
                    badge = wanted[one["name"]]
                    if one["name"] == "energy" and badge.worst is not None:
                        assert one["worst"] == pytest.approx(badge.worst, rel=ALBEDO), (model.label, state)
                    elif one["ok"]:
                        assert one["told"] == told(one["name"], badge)
    assert heard.said == []


def test_a_slider_moves_them(browser, tmp_path):
    """While it moves they are old; at rest they are found anew, in the desktop's words; back at first as they were."""
    found = next(one for one in JUDGED if one.id == "brdfs/phong")
    export(found, tmp_path, poster=False)
    with opened(browser, tmp_path / file_of(found.id)) as (tab, heard):
        settle(tab)
        row = tab.locator(".badges").nth(1)
        first = row.inner_html()
        energy = row.locator("span").nth(2)
        assert energy.get_attribute("class") == "kept"
        tab.evaluate("halfway.change({k_d: 1, k_s: 1})")
        tab.wait_for_selector(".badges.old")
        tab.wait_for_function("() => document.querySelectorAll('.badges')[1].querySelector('.broken')")
        tab.wait_for_function("() => !document.querySelector('.badges.old')")
        wanted = of_model(found.step.models[1], {**defaults(found), "k_d": 1.0, "k_s": 1.0})["energy"]
        assert not wanted.ok and energy.get_attribute("title") == told("energy", wanted)
        tab.evaluate("halfway.change(halfway.defaults())")
        tab.wait_for_function("() => document.querySelector('.badges.old')")
        tab.wait_for_function("() => !document.querySelector('.badges.old')")
        assert row.inner_html() == first
    assert heard.said == []
