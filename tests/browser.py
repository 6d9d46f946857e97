"""Chromium without a window, for tests of pages: one browser a session, software WebGL2."""

import shutil
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
PATIENCE = 120_000  # ms: a busy machine compiles slowly
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

DRAWN = """() => { // how far apart the picture's brightest and darkest pixels are
    halfway.picture(false); // which may give the canvas another size
    const {gpu, canvas} = halfway, gl = gpu.gl, pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const greens = pixels.filter((_, i) => i % 4 === 1);
    return greens.reduce((a, b) => Math.max(a, b)) - greens.reduce((a, b) => Math.min(a, b));
}"""


@dataclass
class Heard:
    """What a tab said on its console, and what it asked for."""

    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)


@contextmanager
def chromium():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def opened(browser, path: Path | str, size: tuple[int, int] = (480, 360), before: str = "", query: str = ""):
    """A tab with a page that has drawn; `before` is a script that runs first."""
    tab = browser.new_page(viewport={"width": size[0], "height": size[1]}, color_scheme="dark")
    tab.set_default_timeout(PATIENCE)
    heard = listening(tab)
    tab.add_init_script(before)
    try:
        if path != "about:blank":
            tab.goto(Path(path).absolute().as_uri() + query)
        yield tab, heard
    finally:
        tab.close()


def listening(tab) -> Heard:
    heard = Heard()
    tab.on("console", lambda message: heard.said.append(f"{message.type}: {message.text}"))
    tab.on("pageerror", lambda error: heard.said.append(str(error)))
    tab.on("request", lambda request: heard.asked.append(request.url))
    return heard


def settle(tab, after: int = 0) -> int:
    """Wait until the page has drawn and counted anew; how often it has."""
    tab.wait_for_function("n => +document.documentElement.dataset.drawn > n", arg=after)
    return int(tab.evaluate("document.documentElement.dataset.drawn"))
