"""The window while a value changes every frame and the plots follow: frames a second, waited for, and plots a second.
And while a formula is typed: from a key to the end of the frame with its picture. Mesa keeps what it has compiled, as
it does for a user; here it begins with nothing, and each key makes another formula (`frames` measures without).

The first row is the same window with nothing moving, drawn as often as it can. Run as a program, it measures one step.
"""

import json
import subprocess
import sys
import tempfile
import time
from itertools import count
from os import environ
from statistics import median

from tests.bench.rows import Row

STEPS = ("solid_angle/patch", "solid_angle/projected", "solid_angle/differential")
BOARD = "board/cook_torrance+oren_nayar+phong"
ASKED = {BOARD: 33.3}  # ms a frame; else 25
TYPED = ("microfacets/cook_torrance", "plausible_shading/board", "plausible_shading/everything", "board/cook_torrance",
         BOARD)  # d_beckmann
ASKED_OF_A_KEY = 100.0
WARM, FRAMES, KEYS, BETWEEN = 60, 200, 12, 6  # frames; keys, and frames between them


def window(rounds: int = 3) -> list[Row]:
    rows = []
    for step, moving in ((STEPS[0], False), *((step, True) for step in (*STEPS, BOARD))):
        found = [once(step, moving) for _ in range(rounds)]
        what = "value moving" if moving else "nothing moving"
        asked = ASKED.get(step, 25.0) if moving else None
        rows.append(Row(f"{step}, {what}", "ms", [1e3 / f["fps"] for f in found], asked=asked))
        if moving:
            rows.append(Row(f"{step}, a plot every", "ms", [1e3 / max(f["plots"], 1e-3) for f in found]))
    for step in TYPED:
        rows.append(Row(f"{step}, a key to its picture", "ms", typed(step), asked=ASKED_OF_A_KEY))
    base = median(rows[0].samples)
    for row in rows:
        row.ratio = row.middle / base
    return rows


def once(step: str, moving: bool) -> dict:
    return alone("measure", step, moving)


def typed(step: str) -> list[float]:
    return alone("type_in", step)


def alone(what: str, *given):
    """In a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "tests.bench.window", what, json.dumps(given)]
        environment = {**environ, "HALFWAY_DATA": folder, "MESA_SHADER_CACHE_DIR": folder}
        environment.pop("DISPLAY", None)
        done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    return json.loads(done.stdout.strip().splitlines()[-1])


def run(the, gui) -> None:
    """Without a display every frame is waited for (the window does so on software GL), so the rate is a real one."""
    from imgui_bundle import hello_imgui, immapp

    from app import locale_alias
    from app.viewer import glfw
    from app.viewer.parameters import parameters

    def frame() -> None:
        is_last = gui()
        hello_imgui.get_runner_params().fps_idling.enable_idling = False
        hello_imgui.get_runner_params().app_shall_exit = is_last

    locale_alias.ensure()
    params, add_ons = parameters(the)
    params.fps_idling.vsync_to_monitor = False
    params.callbacks.show_gui = frame
    glfw.without_display()
    glfw.without_depth()
    immapp.run(params, add_ons)


def measure(step: str, moving: bool) -> None:
    from app.viewer.window import Window

    the = Window(step)
    name = next(n for n, s in the.session.current.values.items() if not s.more and s.quantity.kind == "float")
    spec, times, shown = the.session.current.values[name], [], []

    def gui() -> bool:
        the.gui()
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
        return len(times) == WARM + FRAMES

    run(the, gui)


def type_in(step: str, function: str = "d_beckmann") -> None:
    """Keys in the open editor, once every surface is drawn by a program of its own, as at rest."""
    from app.viewer.window import Window

    the, seconds, frames = Window(step), [], count()
    course = the.session.text(function)

    def gui() -> bool:
        is_key = the.editor.is_open and the.scene.is_settled and next(frames) % BETWEEN == BETWEEN - 1
        start = time.perf_counter()
        if is_key:
            the.editor.typed(course.replace("{", f"{{ m *= 1.0 + {len(seconds) + 1}e-5;", 1))
        the.gui()
        the.ctx.finish()
        if is_key:
            seconds.append(time.perf_counter() - start)
        elif the.scene.stage is not None and not the.editor.is_open:
            the.open_link(f"code:{function}")
        if len(seconds) > KEYS:
            print(json.dumps([1e3 * one for one in seconds[1:]]))  # before the first its editor was opened
        return len(seconds) > KEYS

    run(the, gui)


if __name__ == "__main__":
    globals()[sys.argv[1]](*json.loads(sys.argv[2]))
