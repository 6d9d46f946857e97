"""Once, the window on a real X server; its picture is kept in pictures/ for people to look at."""

import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from app.paths import ROOT

XVFB = shutil.which("xvfb-run")


@pytest.mark.skipif(XVFB is None and not os.environ.get("CI"), reason="needs Xvfb (Debian: xvfb)")
def test_a_real_window_opens_draws_and_closes(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path))
    kept = ROOT / "pictures"
    kept.mkdir(exist_ok=True)
    picture = kept / "window-on-a-display.png"
    # -noreset: without it the server restarts when the last window closes
    display = [XVFB, "-a", "-s", "-screen 0 1600x1000x24 -noreset"]
    command = [*display, sys.executable, "-m", "tests.real_window", str(picture)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, timeout=150, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    seen = json.loads(done.stdout.strip().splitlines()[-1])
    assert seen["display"] and seen["plots"] > 0 and not seen["fault"] and seen["size"] == [1280, 720]
    assert seen["before"] != seen["after"], "the picture follows the value"
    colours = np.asarray(Image.open(picture)).reshape(-1, 3)
    assert len(np.unique(colours[::7], axis=0)) > 500, "text, scene and plot are on it"
