"""A talk on a real X server: two windows of one process, a clicker's keys, a deck's pages, hands, full screen."""

import json
import math
import os
import shutil
import subprocess
import sys

import pytest

from app.paths import ROOT
from tests.test_talk import deck  # noqa: F401  a fixture

XVFB = shutil.which("xvfb-run")


@pytest.mark.skipif(XVFB is None and not os.environ.get("CI"), reason="needs Xvfb (Debian: xvfb)")
def test_a_talk_on_a_real_display(tmp_path, deck):  # noqa: F811
    kept = ROOT / "pictures"
    kept.mkdir(exist_ok=True)
    command = [XVFB, "-a", "-s", "-screen 0 1920x1080x24 -noreset", sys.executable, "-m", "tests.real_talk", str(deck),
               str(kept)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, timeout=200, check=False,
                          env={**os.environ, "HALFWAY_DATA": str(tmp_path)})
    assert done.returncode == 0, done.stderr[-2000:]
    seen = json.loads(done.stdout.strip().splitlines()[-1])
    first, slide, third, back = (seen[name] for name in ("first", "slide", "third", "back"))
    assert seen["display"] and not seen["fault"] and first["windows"] == 2, "the lecturer's window is one of its own"
    assert first["rects"] == ["numbers", "plot", "scene", "slide"] and slide["rects"] == ["slide"]
    assert first["mirror"] == [1280, 720] and seen["unlike"] < 0.5, "it shows what the class sees"
    assert [one["place"] for one in (first, slide, third, back)] == [0, 1, 2, 0]
    assert third["state"] == "fresnel/schlick" and back["state"] == first["state"]
    assert seen["distance"] == 3.123456789, "paging back restores exactly"
    assert seen["black"]["black"] and seen["black"]["light"] < 1 and seen["light again"]["light"] > 100
    assert seen["light again"]["place"] == 0, "a clicker's next key brings the picture back before it moves on"
    assert not math.isclose(seen["moving"]["tilt"], back["tilt"])
    asked, told = seen["asked"], seen["told"]
    assert asked["frozen"] and asked["hands"] == 4 and asked["rects"] == ["scene"], "nothing tells the answer"
    assert not told["frozen"] and told["rects"] == ["plot", "scene"]
    assert seen["full"]["size"] == [1920, 1080] and seen["end"]["size"] == [1280, 720] and seen["end"]["hands"] is None
