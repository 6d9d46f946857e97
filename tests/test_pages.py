"""Exported pages in a real browser: they load alone, show the desktop's picture and the desktop's numbers, and can be
dragged, framed, asked, broken and mended."""

import base64
import gzip
import io
import json
import os
import re
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from app import meshes
from app.breaking import values_of
from app.catalog import step, steps
from app.export.still import data
from app.export.web import math
from app.export.web.command import export, wanted
from app.export.web.content import content, contrast, inks
from app.export.web.page import file_of, script
from app.gpu.evaluate import evaluate
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.mesh_edges import corner_normals
from app.problem import Usage
from app.state import View, defaults, parse, write
from app.terms import bound
from app.terms import evaluate as evaluate_exactly
from app.theme import THEMES
from app.tolerance import FACTOR, ratio
from tests.browser import CHROMIUM, opened, settle
from tests.test_twins import COUNTED, NAIVE

pytestmark = pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
PATCH = "solid_angle/patch"
LARGEST, ZIPPED, WITHOUT_MATH, STILLS = 900_000, 420_000, 250_000, 80_000  # bytes of a page; of its stills at most
SMALL = (160, 120)
STRAY = 5  # pixels of 19200 at the very ends of lines and dots
SEE = f"""() => {{
    const page = window.halfway, gl = page.gpu.gl;
    page.canvas.style.cssText = "width: {SMALL[0]}px; height: {SMALL[1]}px; min-height: 0";
    page.heavy = false; // all its pixels, however busy the machine is
    page.picture(false);
    const pixels = new Uint8Array({4 * SMALL[0] * SMALL[1]});
    gl.readPixels(0, 0, {SMALL[0]}, {SMALL[1]}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    page.canvas.style.cssText = "";
    return btoa(String.fromCharCode(...pixels.subarray(0, 40000)) + String.fromCharCode(...pixels.subarray(40000)));
}}"""
MOVE = """() => {
    const moved = {picture: false, numbers: false}, page = window.halfway, see = """ + SEE + """;
    const told = () => { page.tell(); return document.getElementById("numbers").textContent; };
    const before = [see(), told()];
    const look = () => {
        moved.picture ||= see() !== before[0];
        moved.numbers ||= told() !== before[1];
        return moved.picture && moved.numbers;
    };
    for (const slider of document.querySelectorAll(".rows input[type=range]")) {
        slider.value = +slider.value > 0.5 ? +slider.value - 0.31 : +slider.value + 0.31;
        slider.dispatchEvent(new Event("input"));
        if (look()) return moved;
    }
    for (const radio of document.querySelectorAll(".rows input[type=radio]:not(:checked)")) {
        radio.click();
        if (look()) return moved;
    }
    return moved;
}"""
FONTS = """() => {
    const kept = new Set([...document.fonts].filter(font => font.family.startsWith("KaTeX")).map(f => f.family));
    const asked = [...document.querySelectorAll(".katex-html span")].map(one => getComputedStyle(one).fontFamily)
        .map(name => name.split(",")[0].trim()).filter(name => name.startsWith("KaTeX"));
    return {missing: asked.filter(name => !kept.has(name)), set: document.querySelectorAll(".katex-html").length,
            wrong: document.querySelectorAll(".katex-error").length};
}"""


@pytest.fixture(scope="module")
def visitor(browser):
    """A small tab that goes from page to page."""
    with opened(browser, "about:blank", (260, 200)) as found:
        yield found


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("pages")
    for one in steps():
        export(one, found, poster=False)
    return found


def pixels(text: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), np.uint8).reshape(SMALL[1], SMALL[0], 4)[::-1, :, :3].astype(int)


def desktop(found, values: dict, ctx) -> tuple[np.ndarray, np.ndarray]:
    """The desktop's picture; and where no silhouette or line runs, so that rounding decides nothing: pixels that are
    like their neighbours, and stay as they are when the camera moves by a tenth of a degree."""
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    camera = found.step.scene.camera

    def seen(azimuth: float = 0.0, elevation: float = 0.0) -> np.ndarray:
        there = replace(camera, azimuth=camera.azimuth + azimuth, elevation=camera.elevation + elevation)
        stage.draw(values, there, SMALL, THEMES["dark"], fine=False)
        return stage.picture.pixels().astype(int)

    try:
        picture = seen()
        moved = [seen(x, y) for x in (-0.1, 0.1) for y in (-0.1, 0.1)]
    finally:
        stage.release()
    padded = np.pad(picture, ((1, 1), (1, 1), (0, 0)), "edge")
    around = [padded[1 + y:1 + y + SMALL[1], 1 + x:1 + x + SMALL[0]] for y in (-1, 0, 1) for x in (-1, 0, 1)]
    flat = np.ptp(np.array(around), axis=0).max(-1) <= 6
    return picture, flat & (np.abs(np.array(moved) - picture).max((0, -1)) <= 2)


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_a_page_is_the_step(found, folder, visitor, ctx):
    """It loads without a word and without a request, within its size; its picture and numbers are the desktop's; a
    slider moves both; its formulas have their fonts."""
    path = folder / file_of(found.id)
    raw = path.read_bytes()
    assert len(raw) <= LARGEST - STILLS and len(gzip.compress(raw)) <= ZIPPED - STILLS
    assert len(raw) - formulas(found) * (b'class="tex"' in raw) <= WITHOUT_MATH - STILLS
    tab, heard = visitor
    heard.said.clear()
    heard.asked.clear()
    tab.goto(path.absolute().as_uri())
    settle(tab)
    seen, told = pixels(tab.evaluate(SEE)), tab.evaluate("halfway.report('state')")
    moved, fonts = tab.evaluate(MOVE), tab.evaluate(FONTS)
    assert heard.said == [] and heard.asked == [path.absolute().as_uri()]
    assert moved == {"picture": True, "numbers": True}
    assert fonts["missing"] == [] and fonts["wrong"] == 0
    assert fonts["set"] == raw.count(b'class="tex"')
    values = defaults(found)
    values |= data(found, values)
    for readout in found.step.readouts:
        same_number(readout.term, values, told["numbers"][readout.label], ctx)
    theirs, calm = desktop(found, values, ctx)
    assert calm.mean() > 0.4
    off = np.abs(seen - theirs).max(-1)[calm]
    assert np.count_nonzero(off > 2) <= STRAY


def same_number(term, values: dict, got: float, ctx) -> None:
    """The page's number is the GLSL twin's: within its tolerance of float64, or beside the desktop's float32."""
    args = {name: np.asarray(x).astype("f4").astype(float) if np.asarray(x).dtype.kind == "f" else x
            for name, x in bound(term, values).items()}
    got = np.nan if got is None else got
    if term.function in {*NAIVE, *COUNTED}:
        np.testing.assert_allclose(got, evaluate(term.function, args, ctx=ctx), rtol=1e-4)
        return
    value = np.asarray(evaluate(term.function, args, ctx=ctx), float)
    if np.isnan(value):
        assert np.isnan(got)
        return
    found = ratio(term.function, args, got)
    assert found <= FACTOR, (term.function, got, float(value), float(found))


# --- one page, closely -----------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def patched(folder, browser):
    with opened(browser, folder / file_of(PATCH), (960, 600)) as found:
        settle(found[0])
        yield found


@pytest.fixture
def patch(patched):
    """The page as it is at first."""
    tab, heard = patched
    tab.evaluate("halfway.restyle('dark')")
    tab.locator("#reset").click()
    settle(tab, settle(tab) - 1)
    yield tab
    assert heard.said == []


def number(tab, label: str) -> float:
    return tab.evaluate("label => halfway.report('state').numbers[label]", label)


def test_a_drag_takes_the_thing_along(patch):
    grip = patch.locator(".grip").nth(0)
    box = grip.bounding_box()
    before = patch.evaluate("({...halfway.values})")
    patch.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    patch.mouse.down()
    for i in range(1, 6):
        patch.mouse.move(box["x"] + box["width"] / 2 - 8 * i, box["y"] + box["height"] / 2 - 5 * i)
    at = patch.evaluate("halfway.frames")
    patch.mouse.up()
    settle(patch, at - 1)
    after = patch.evaluate("({...halfway.values})")
    moved = {name for name in after if after[name] != before[name]}
    assert moved == set(step(PATCH).step.scene.handles[0].values)
    there = grip.bounding_box()
    assert abs(there["x"] - box["x"] + 40) < 3 and abs(there["y"] - box["y"] + 25) < 3


def test_a_link_a_slider_and_a_typed_number_set_the_same(patch):
    settled = settle(patch)
    patch.locator(".prose a").first.click()
    settle(patch, settled)
    found = step(PATCH)
    link = patch.locator(".prose a").first.get_attribute("href")
    assert patch.evaluate("halfway.state()") == link[1:]
    patch.locator("#reset").click()
    assert patch.evaluate("halfway.state()") == ""
    patch.locator("#value-tilt").fill("0.75")
    assert patch.evaluate("halfway.values.tilt") == pytest.approx(np.pi / 4)
    field = patch.get_by_label("tilt β in °")
    assert field.input_value() == "45"
    field.fill("-30")
    field.press("Enter")
    values = parse(f"{PATCH}?tilt=-30").values
    assert patch.evaluate("halfway.values.tilt") == pytest.approx(values["tilt"], rel=1e-12)
    assert patch.evaluate("halfway.state()") == write(found, values).partition("?")[2]


def test_a_guess_and_the_truth(patch):
    patch.locator("#reveal").click()
    ask = step(PATCH).step.ask
    assert patch.locator("#told").inner_text() == ask.told
    assert patch.locator("#verdict").inner_text()


def test_the_address_is_the_state(folder, browser):
    found = step(PATCH)
    state = parse(f"{PATCH}?distance=2.5&tilt=30&view=-20,40,6")
    query = write(found, state.values, state.view).partition("?")[2]
    with opened(browser, folder / file_of(PATCH), query=f"?{query}") as (tab, _):
        settle(tab)
        assert tab.evaluate("halfway.state()") == query
        assert tab.evaluate("halfway.values.distance") == 2.5
        tab.locator("#value-width").fill("0.9")
        tab.wait_for_function("() => location.search.includes('width=')")
        again = parse(PATCH + tab.evaluate("location.search"))
        assert again.values["distance"] == 2.5 and again.view == View(-20, 40, 6)


def test_broken_and_mended(folder, browser):
    """The naive form, at the values where it fails, in picture and numbers; and back."""
    found = step("radiometry/inverse_square")
    one, first = found.step.breaks[0], found.step.readouts[0].label
    with opened(browser, folder / file_of(found.id)) as (tab, heard):
        settle(tab)
        programs = tab.evaluate("JSON.stringify(halfway.stage.scene.programs)")
        tab.locator(".break input").check()
        tab.wait_for_function("() => halfway.state().includes('radius=0.0006')")
        right, wrong = number(tab, one.number), number(tab, f"{one.number}, broken")
        exact = float(evaluate_exactly(one.term, defaults(found) | values_of(found, one)))
        assert right == pytest.approx(exact, rel=1e-5) and abs(wrong / exact - 1) > 1e-2
        assert one.told in tab.locator("#broken").inner_text()
        rows = tab.locator("#numbers")
        assert rows.get_by_text(f"{one.number}, broken", exact=True).is_visible()
        assert not rows.get_by_text(first, exact=True).is_visible()
        assert tab.evaluate("JSON.stringify(halfway.stage.scene.programs)") != programs
        tab.locator(".break input").uncheck()
        assert number(tab, first) == pytest.approx(1.1309734e-4, rel=1e-5)
        assert rows.get_by_text(first, exact=True).is_visible()
        assert tab.evaluate("JSON.stringify(halfway.stage.scene.programs)") == programs
    assert heard.said == []


def test_a_decided_choice_is_a_constant(folder, browser):
    """Its programs are compiled for each value once: going back compiles nothing."""
    found = step("lights/area_sampled")
    name = found.step.scene.decided[0]
    first = defaults(found)[name]
    other = next(x for x in range(len(found.values[name].choices)) if x != first)
    texts = f"[...halfway.gpu.programs.keys()].filter(text => text.includes('const int {name} = %d;')).length"
    with opened(browser, folder / file_of(found.id)) as (tab, heard):
        drawn = settle(tab)
        before, numbers = tab.evaluate(texts % first), tab.evaluate("halfway.report().numbers")
        assert before > 0 == tab.evaluate(texts % other)
        tab.evaluate(f"halfway.change({{{name}: {other}}})")
        drawn = settle(tab, drawn)
        kept = tab.evaluate(texts % first)
        assert tab.evaluate(texts % other) > 0 and tab.evaluate("halfway.report().numbers") != numbers
        tab.evaluate(f"halfway.change({{{name}: {first}}})")
        settle(tab, drawn)
        assert tab.evaluate(texts % first) == kept
    assert heard.said == []


def test_faulty_pixels_are_counted(folder, browser):
    """A radiance below 0 everywhere: the page says how many pixels have it."""
    with opened(browser, folder / file_of("solid_angle/cone")) as (tab, _):
        settle(tab)
        assert tab.locator("#faults").inner_text() == ""
        tab.evaluate("""() => {
            for (const pair of Object.values(halfway.content.scene.programs))
                if (pair[1]) pair[1] = pair[1].replace("vec3 radiance = shade(s);", "vec3 radiance = vec3(-1.0);");
            halfway.stage.begin();
            clearTimeout(halfway.resting);
            halfway.rest();
        }""")
        assert re.fullmatch(r"[1-9]\d* pixels negative", tab.locator("#faults").inner_text())


def test_meshes_are_the_desktops(folder, browser):
    with opened(browser, folder / file_of("plausible_shading/second_opinion")) as (tab, _):
        for name in meshes.BUILT_IN:
            told = tab.evaluate("name => Object.values(mesh(name)).map(one => one.corners[0].flat())", name)
            triangles = meshes.built_in(name).triangles
            np.testing.assert_allclose(told[0], triangles.ravel(), rtol=0, atol=1e-7)
            np.testing.assert_allclose(told[1], corner_normals(triangles).ravel(), rtol=0, atol=1e-6)


def test_a_lost_context_comes_back(patch):
    before = patch.evaluate(SEE)
    patch.evaluate("""() => { window.lose = halfway.gpu.gl.getExtension("WEBGL_lose_context"); lose.loseContext(); }""")
    patch.wait_for_selector(".lost-note", state="visible")
    drawn = patch.evaluate("halfway.frames")
    patch.evaluate("lose.restoreContext()")
    settle(patch, drawn)
    assert patch.evaluate(SEE) == before
    assert not patch.locator(".lost-note").is_visible()


@pytest.mark.parametrize("id", ["brdfs/phong", "plausible_shading/compare"])
def test_the_heaviest_pages_fit_with_their_stills(id, tmp_path):
    export(step(id), tmp_path, poster=True)
    raw = (tmp_path / file_of(id)).read_bytes()
    assert raw.count(b"data:image/webp") >= 2 and len(raw) - formulas(step(id)) <= WITHOUT_MATH
    assert len(raw) <= LARGEST and len(gzip.compress(raw)) <= ZIPPED


def formulas(found) -> int:
    """How many bytes a page carries for its formulas."""
    return len((math.script() + math.style(math.fonts(found.step.prose + found.step.notes)) + math.licence()).encode())


def test_without_webgl_it_is_a_still(tmp_path, browser):
    export(step(PATCH), tmp_path, poster=True)
    still = Image.open(tmp_path / "solid_angle-patch.png")
    assert still.size == (1280, 720) and still.text["halfway:state"] == PATCH
    with opened(browser, tmp_path / file_of(PATCH), before="delete HTMLCanvasElement.prototype.getContext;"
                "HTMLCanvasElement.prototype.getContext = () => null") as (tab, heard):
        assert tab.locator(".poster").is_visible() and tab.locator(".still-note").is_visible()
        assert tab.evaluate("document.querySelector('.poster').naturalWidth") > 400
        assert 0 < tab.locator(".tex").count() == tab.locator(".tex .katex").count()  # set all the same
    assert heard.said == []


FRAME = """<!DOCTYPE html><title>deck</title><button id="deck">deck</button>
<iframe sandbox="allow-scripts" src="{page}?tilt=10#scene" width="800" height="600"></iframe>
<script>const heard = []; addEventListener("message", event => heard.push(event.data));
let frame = document.querySelector("iframe");
const say = data => frame.contentWindow.postMessage(data, "*");</script>"""


def test_a_sandboxed_frame_listens_and_gives_the_keys_back(folder, browser):
    deck = folder / "deck.html"
    deck.write_text(FRAME.format(page=file_of(PATCH)), encoding="utf-8")
    with opened(browser, deck, (900, 700)) as (tab, heard):
        tab.wait_for_function("heard.some(one => one.halfway === 'ready')")
        tab.evaluate("say({halfway: 'set', state: 'solid_angle/patch?distance=3&tilt=20'})")
        tab.evaluate("say({halfway: 'get'}); say({halfway: 'snapshot'})")
        tab.wait_for_function("heard.some(one => one.halfway === 'snapshot')")
        told = tab.evaluate("heard.filter(one => one.halfway === 'state').at(-1)")
        picture = tab.evaluate("heard.find(one => one.halfway === 'snapshot').png")
        assert told["step"] == PATCH and told["state"] == "distance=3&tilt=20" and told["values"]["distance"] == 3
        png = Image.open(io.BytesIO(base64.b64decode(picture.partition(",")[2])))
        assert np.ptp(np.asarray(png.convert("L"))) > 60
        frame = tab.frame_locator("iframe")
        assert not frame.locator("article").is_visible()
        frame.locator("#picture").click()
        assert tab.evaluate("document.activeElement.tagName") == "IFRAME"
        tab.keyboard.press("Escape")
        tab.wait_for_function("heard.some(one => one.halfway === 'escape')")
        tab.wait_for_function("document.activeElement.tagName !== 'IFRAME'")
    assert heard.said == []


def test_a_deck_that_loads_and_unloads_its_slides(folder, browser):
    """As reveal.js does: a frame's src comes when its slide is shown and goes with it, oftener than contexts live."""
    deck = folder / "deck.html"
    deck.write_text(FRAME.format(page=file_of("solid_angle/cone")), encoding="utf-8")
    with opened(browser, deck, (300, 240)) as (tab, heard):
        for i in range(1, 19):
            tab.wait_for_function("n => heard.filter(one => one.halfway === 'ready').length === n", arg=i)
            tab.evaluate("() => { const next = frame.cloneNode(); frame.replaceWith(next); frame = next; }")
        tab.wait_for_function("heard.filter(one => one.halfway === 'ready').length === 19")
        tab.evaluate("say({halfway: 'set', state: 'half_angle=30'}); say({halfway: 'get'})")
        tab.wait_for_function("heard.some(one => one.halfway === 'state' && one.state.includes('half_angle=30'))")
    assert heard.said == []


def test_a_page_may_ask_for_nothing(folder, browser):
    with opened(browser, folder / file_of(PATCH)) as (tab, heard):
        settle(tab)
        blocked = tab.evaluate("""async () => {
            const bad = document.createElement("script");
            bad.textContent = "window.ran = true";
            document.body.append(bad);
            return [window.ran === true, await fetch("https://example.org/").then(() => true, () => false)];
        }""")
        assert blocked == [False, False]
        assert len([said for said in heard.said if "Content Security Policy" in said]) >= 2
        assert len(heard.asked) == 1


def test_everything_has_a_name_and_can_be_reached(patch):
    nameless = patch.evaluate("""() => [...document.querySelectorAll("input, button, canvas, summary, a")]
        .filter(one => !(one.getAttribute("aria-label") || one.labels?.length || one.textContent.trim()))
        .map(one => one.outerHTML)""")
    assert nameless == []
    patch.locator("#picture").focus()
    reached = []
    for _ in range(6):
        patch.keyboard.press("Tab")
        reached.append(patch.evaluate("document.activeElement.id || document.activeElement.tagName"))
    assert {"reset", "theme", "value-distance"} <= set(reached)
    before = patch.evaluate("halfway.values.distance")
    patch.locator("#value-distance").focus()
    patch.keyboard.press("ArrowRight")
    assert patch.evaluate("halfway.values.distance") > before


def test_themes_follow(patch):
    ground = "getComputedStyle(document.documentElement).backgroundColor"
    dark = patch.evaluate(ground)
    patch.locator("#theme").click()
    assert patch.evaluate("document.documentElement.dataset.theme") == "light"
    assert patch.evaluate(ground) != dark


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_words_can_be_read(theme):
    assert contrast("#000000", "#FFFFFF") == pytest.approx(21)
    assert contrast("#767676", "#FFFFFF") == pytest.approx(4.54, 1e-3)  # the grey that W3C names as just enough
    css = inks(theme)
    for name in ("quiet", "foreground", *(name for name in css if name.endswith("-text"))):
        assert min(contrast(css[name], css[ground]) for ground in ("background", "panel")) >= 4.5, name


@pytest.mark.parametrize("size", [(390, 844), (844, 390), (1280, 720), (1920, 1080)])
def test_nothing_sticks_out(size, folder, browser):
    with opened(browser, folder / file_of("brdfs/phong"), size) as (tab, _):
        settle(tab)
        assert tab.evaluate("document.documentElement.scrollWidth") <= size[0]
        assert tab.evaluate("document.getElementById('picture').clientWidth") > 0.3 * size[0]


# --- the course ------------------------------------------------------------------------------------------------------
def test_the_command(tmp_path, capsys):
    from app.__main__ import main

    assert main(["export", "solid_angle/cone", "solid_angle/angle", "-o", str(tmp_path / "out"), "--no-poster"]) == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "index.html", "solid_angle-angle.html", "solid_angle-cone.html"}
    assert "2 of 2 pages." in capsys.readouterr().out
    assert [found.id for found in wanted(["fresnel"], False)] == [s.id for s in steps() if s.loaded.id == "fresnel"]
    with pytest.raises(Usage, match="--all"):
        wanted([], False)
    with pytest.raises(Usage, match="solid_angle/patch"):
        wanted(["solid_angle/pach"], False)


def test_a_page_carries_only_what_it_uses():
    cone, mesh = (content(step(id)) for id in ("solid_angle/cone", "solid_angle/mesh"))
    assert not cone["meshes"] and len(mesh["meshes"]) == len(step("solid_angle/mesh").step.scene.meshes)
    for one in map(content, steps()):
        used = {"grabbing": one["scene"]["handles"], "breaking": one["breaks"], "mesh": one["meshes"]}
        assert [f"function {name}(" in script(one) for name in used] == [bool(parts) for parts in used.values()]
    text = json.dumps(cone["twins"])
    assert "solid_angle_mesh" not in text and "careful_cos" not in cone["twins"]["solid_angle_cone"]["text"]
    assert math.fonts("no formulas") == math.ALWAYS
    assert "KaTeX_Size2-Regular" in math.fonts(r"$\sqrt{2}$")
    assert not re.search(r"@font-face\{[^}]*AMS", math.style(math.ALWAYS))

