"""From a `.brdf` that is dropped on a running window to its first picture on the board."""

import json
import subprocess
import sys
import tempfile
import time
from os import environ
from pathlib import Path

from tests.bench.rows import Row

TEXT = """analytic
::begin parameters
float alpha 0.01 1 0.3
color tint 1 .7 .3
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 H = normalize(L + V);
    float c = dot(N, H), a = alpha * alpha, d = c * c * (a - 1.0) + 1.0;
    return tint * a / (12.566 * d * d) + 0.02;
}
::end shader
"""


def board(rounds: int = 3) -> list[Row]:
    return [Row("a .brdf dropped: to its picture", "ms", [once() for _ in range(rounds)], asked=1000.0)]


def once() -> float:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "dropped.brdf"
        path.write_text(TEXT, "utf-8")
        environment = {**environ, "HALFWAY_DATA": folder}
        environment.pop("DISPLAY", None)
        command = [sys.executable, "-m", "tests.bench.board", str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    return json.loads(done.stdout.strip().splitlines()[-1])["ms"]


def measure(path: str) -> None:
    from imgui_bundle import hello_imgui, immapp

    from app import locale_alias
    from app.viewer import glfw
    from app.viewer.parameters import parameters
    from app.viewer.window import Window

    locale_alias.ensure()
    the = Window("solid_angle/patch")
    params, add_ons = parameters(the)
    begun = [0.0]

    def gui() -> None:
        if the.frame == 20 and not begun[0]:
            begun[0] = time.perf_counter()
            the.dropped.append(path)
        the.gui()
        hello_imgui.get_runner_params().fps_idling.enable_idling = False
        if begun[0] and the.session.current.id.startswith("board/"):
            the.ctx.finish()
            print(json.dumps({"ms": 1e3 * (time.perf_counter() - begun[0])}))
            hello_imgui.get_runner_params().app_shall_exit = True

    params.callbacks.show_gui = gui
    glfw.without_display()
    glfw.without_depth()
    immapp.run(params, add_ons)


if __name__ == "__main__":
    measure(sys.argv[1])
