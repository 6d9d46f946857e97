"""The window while a value changes every frame and the plots follow: frames a second, waited for, and plots a second.

The first row is the same window with nothing moving, drawn as often as it can. Run as a program, it measures one step.
"""

import json
import subprocess
import sys
import tempfile
import time
from os import environ
from statistics import median

from tests.bench.rows import Row

STEPS = ("solid_angle/patch", "solid_angle/projected", "solid_angle/differential")
BOARD = "board/cook_torrance+oren_nayar+phong"
ASKED = {BOARD: 33.3}  # ms a frame; else 25
WARM, FRAMES = 60, 200


def window(rounds: int = 3) -> list[Row]:
    rows = []
    for step, moving in ((STEPS[0], False), *((step, True) for step in (*STEPS, BOARD))):
        found = [once(step, moving) for _ in range(rounds)]
        what = "value moving" if moving else "nothing moving"
        asked = ASKED.get(step, 25.0) if moving else None
        rows.append(Row(f"{step}, {what}", "ms", [1e3 / f["fps"] for f in found], asked=asked))
        if moving:
            rows.append(Row(f"{step}, a plot every", "ms", [1e3 / max(f["plots"], 1e-3) for f in found]))
    base = median(rows[0].samples)
    for row in rows:
        row.ratio = row.middle / base
    return rows


def once(step: str, moving: bool) -> dict:
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "tests.bench.window", step, str(int(moving))]
        environment = {**environ, "HALFWAY_DATA": folder}
        environment.pop("DISPLAY", None)
        done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    return json.loads(done.stdout.strip().splitlines()[-1])


def measure(step: str, moving: bool) -> None:
    """Without a display every frame is waited for (the window does so on software GL), so the rate is a real one."""
    from imgui_bundle import hello_imgui, immapp

    from app import locale_alias
    from app.viewer import glfw
    from app.viewer.parameters import parameters
    from app.viewer.window import Window

    locale_alias.ensure()
    the = Window(step)
    params, add_ons = parameters(the)
    params.fps_idling.vsync_to_monitor = False
    name = next(n for n, s in the.session.current.values.items() if not s.more and s.quantity.kind == "float")
    spec, times, shown = the.session.current.values[name], [], []

    def gui() -> None:
        the.gui()
        hello_imgui.get_runner_params().fps_idling.enable_idling = False
        times.append(time.perf_counter())
        if len(times) == WARM - 5:
            while the.plot.process and not the.plot.process.idle:  # VTK has started
                time.sleep(0.02)
        if len(times) == WARM:
            shown.append(the.plot.shown)
        if moving and len(times) > WARM:
            share = 0.2 + 0.6 * (len(times) % 100) / 100
            the.session.set(name, spec.low + (spec.high - spec.low) * share)
        if len(times) == WARM + FRAMES:
            seconds = times[-1] - times[WARM]
            print(json.dumps({"fps": FRAMES / seconds, "plots": (the.plot.shown - shown[0]) / seconds}))
            hello_imgui.get_runner_params().app_shall_exit = True

    params.callbacks.show_gui = gui
    glfw.without_display()
    glfw.without_depth()
    immapp.run(params, add_ons)


if __name__ == "__main__":
    measure(sys.argv[1], bool(int(sys.argv[2])))
