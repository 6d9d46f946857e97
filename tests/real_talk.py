"""`python -m tests.real_talk DECK FOLDER`: a talk on a real display, driven by a clicker's keys and photographed."""

import json
import sys
import time
from pathlib import Path

import numpy as np
from imgui_bundle import hello_imgui, imgui, immapp

from app import locale_alias
from app.cues import Stop
from app.deck import Deck
from app.viewer import glfw
from app.viewer.lecturer import LOOK_EVERY
from app.viewer.presenter import Presenter, prepared

KEY = imgui.Key
STOPS = (Stop("solid_angle/patch?distance=2.5", 1, sweep="tilt=-60..60"), Stop(page=2), Stop("fresnel/schlick", 3))


class Clicker:
    """Presses keys, waits until the window is at rest, and notes what is seen."""

    def __init__(self, window: Presenter, folder: Path) -> None:
        self.window, self.folder, self.seen = window, folder, {}
        self.script, self.waited, self.begun = self.talk(), 0, time.monotonic()
        self.wait, self.went_on = 12, time.monotonic()

    def frame(self) -> None:
        self.window.gui()
        self.waited += 1
        window = self.window
        busy = window.talk.has_scene and not window.talk.is_black and not window.talk.playing and (
            window.plot.waiting or not window.scene.is_fine)
        fresh = time.monotonic() - self.went_on > 2 * LOOK_EVERY  # the lecturer's picture is newer than the last key
        if self.waited < self.wait or not fresh or (busy and time.monotonic() - self.begun < 90):
            return
        self.waited, self.went_on = 0, time.monotonic()
        if next(self.script, "over") == "over":
            hello_imgui.get_runner_params().app_shall_exit = True

    def press(self, key) -> None:
        io = imgui.get_io()
        io.add_key_event(key, True)
        io.add_key_event(key, False)

    def note(self, name: str) -> None:
        window, main = self.window, imgui.get_main_viewport()
        mirror = window.lecturer.texture  # the class's picture, as the lecturer sees it
        self.mirror = np.frombuffer(mirror.read(), np.uint8).reshape(mirror.height, mirror.width, 3)[::-1]
        self.seen[name] = {
            "place": window.talk.place, "state": window.session.state, "rects": sorted(window.rects),
            "light": float(self.mirror.mean()), "size": [int(main.size.x), int(main.size.y)],
            "mirror": list(mirror.size), "message": window.message, "black": window.talk.is_black,
            "tilt": window.session.values.get("tilt"), "hands": window.talk.hands and window.talk.hands.total,
            "frozen": window.session.frozen, "windows": len(imgui.get_platform_io().viewports)}

    def talk(self):
        window = self.window
        yield
        window.session.set("distance", 3.123456789)
        yield
        self.note("first")
        self.press(KEY.page_down)
        yield
        self.note("slide")
        self.press(KEY.page_down)
        yield
        self.note("third")
        for _ in range(2):
            self.press(KEY.page_up)
            yield
        self.note("back")
        self.seen["distance"] = window.session.values["distance"]
        self.press(KEY.b)
        yield
        self.note("black")
        self.press(KEY.page_down)
        yield
        self.note("light again")
        self.press(KEY.space)
        yield
        self.note("moving")
        self.press(KEY.space)
        yield
        self.press(KEY.h)
        yield
        window.talk.hands.take("0.3x3 0.5")
        yield
        self.note("asked")
        self.press(KEY.v)
        yield
        self.note("told")
        self.press(KEY.f11)
        yield
        yield
        self.note("full")
        self.press(KEY.escape)
        yield
        self.press(KEY.escape)
        yield
        yield
        self.note("end")


def main(deck: str, folder: str) -> None:
    locale_alias.ensure()
    window = Presenter(STOPS, 0, Deck(deck), size=(1280, 720))
    params, add_ons = prepared(window)
    clicker = Clicker(window, Path(folder))
    params.callbacks.show_gui = clicker.frame
    immapp.run(params, add_ons)
    from PIL import Image

    last = Image.fromarray(hello_imgui.final_app_window_screenshot()).convert("RGB")
    last.save(Path(folder) / "a-talk.png")
    apart = np.abs(np.asarray(last).astype(int) - clicker.mirror) if last.size == clicker.mirror.shape[1::-1] else 255
    clicker.seen["unlike"] = float(np.mean(apart))
    print(json.dumps(clicker.seen | {"display": glfw.has_display(), "fault": window.own.fault}))


if __name__ == "__main__":
    main(*sys.argv[1:])
