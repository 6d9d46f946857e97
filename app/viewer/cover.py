"""The first picture, turning slowly."""

import importlib.util
import time
from dataclasses import replace

from imgui_bundle import ImVec2, imgui

from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.paths import LESSONS

DEGREES_A_SECOND = 5.0
ASIDE = 0.16  # of the width: the picture stands right of the title


class Cover:
    def __init__(self, app) -> None:
        self.app, self.begun = app, 0.0
        self.stage: Stage | None = None

    def draw(self, size: ImVec2) -> None:
        if self.stage is None:
            spec = importlib.util.spec_from_file_location("lessons.cover", LESSONS / "cover.py")
            assert spec and spec.loader
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
            self.stage, self.begun = Stage(self.app.ctx, Source(module.COVER, "lessons/cover.py")), time.monotonic()
        camera = self.stage.scene.camera
        turned = replace(camera, azimuth=camera.azimuth + DEGREES_A_SECOND * (time.monotonic() - self.begun))
        scale = imgui.get_io().display_framebuffer_scale
        pixels = int(size.x * scale.x), int(size.y * scale.y)
        self.stage.draw({}, turned, pixels, self.app.theme, counted=False)
        self.app.ctx.screen.use()
        texture = self.stage.picture.texture
        imgui.image(imgui.ImTextureRef(texture.glo), size, uv0=ImVec2(-ASIDE, 1), uv1=ImVec2(1 - ASIDE, 0))

    def release(self) -> None:
        if self.stage:
            self.stage.release()
