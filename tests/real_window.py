"""`python -m tests.real_window PICTURE`: the window on a real display, driven for a moment and photographed."""

import json
import sys
import time

from imgui_bundle import hello_imgui, immapp

from app import locale_alias
from app.viewer import glfw
from app.viewer.parameters import parameters
from app.viewer.window import Window


def main(picture: str) -> None:
    """Open it, change a value, wait for the plot, close it; print what was seen as JSON."""
    locale_alias.ensure()
    window = Window("solid_angle/patch", size=(1280, 720))
    params, add_ons = parameters(window)
    begun, seen = time.monotonic(), {}

    def gui() -> None:
        window.gui()
        if window.frame == 3:
            seen["before"] = window.scene.stage.picture.pixels().mean()
            window.session.set("distance", 3.0)
        ready = window.frame > 10 and window.plot.shown > 0 and not window.plot.waiting and window.scene.is_fine
        if ready or time.monotonic() - begun > 60:
            seen["after"] = window.scene.stage.picture.pixels().mean()
            hello_imgui.get_runner_params().app_shall_exit = True

    params.callbacks.show_gui = gui
    immapp.run(params, add_ons)
    from PIL import Image

    photograph = hello_imgui.final_app_window_screenshot()
    Image.fromarray(photograph).convert("RGB").save(picture)
    print(json.dumps({"display": glfw.has_display(), "before": float(seen["before"]), "after": float(seen["after"]),
                      "plots": window.plot.shown, "fault": window.own.fault, "size": photograph.shape[:2][::-1]}))


if __name__ == "__main__":
    main(sys.argv[1])
