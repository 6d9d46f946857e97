"""What a picture costs: vertices, texels, compilation, frames, memory; beside the same picture with everything on."""

import time
from dataclasses import dataclass
from statistics import median

from app.catalog import LoadedStep
from app.everything import EverythingOn
from app.gpu.context import context, pixel
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, vertices
from app.theme import THEMES

SIZE = 512, 512  # px
ROUNDS = 7  # frames of each at most, in turn, so that both meet the same disturbances
FEWEST, ALIKE = 3, 0.06  # frames after which the median is taken if they differ by no more than this share


@dataclass(frozen=True)
class Cost:
    """Of one picture of 512 x 512 as a moving window draws it; times in ms, the median frame."""

    vertices: int
    texels: int  # of constant data: meshes, tables
    samples: int  # points drawn, or taken of a light at each pixel
    memory_kb: int  # buffers, textures and targets
    compile_ms: float  # to the end of the first frame, less a later one: drivers compile when a program is first used
    frame_ms: float
    everything_compile_ms: float
    everything_frame_ms: float

    @property
    def ratio(self) -> float:
        """This frame over the one with everything on."""
        return self.frame_ms / self.everything_frame_ms


def cost(found: LoadedStep, values: dict, rounds: int = ROUNDS) -> Cost:
    """Measured here and now; the values carry the step's triangles and tables."""
    scene, source = found.step.scene, Source(found.step.scene, found.file_name, found.glsl_line)
    made = {kind: first_frame(kind, source, values) for kind in (Stage, EverythingOn)}
    times: dict = {kind: [] for kind in made}
    for _ in range(rounds):
        for kind, (stage, _) in made.items():
            times[kind].append(frame(stage, values))
        if all(len(found) >= FEWEST and max(found) - min(found) <= ALIKE * min(found) for found in times.values()):
            break
    own, all_on = (median(times[kind]) for kind in made)
    stage = made[Stage][0]
    memory, texels = held(stage)
    for one, _ in made.values():
        one.release()
        for use in set(one.programs.values()):  # here they are the stage's own
            use.release()
    return Cost(sum(vertices(scene, values.get("triangles"), values).values()), texels, samples(values), memory,
                1e3 * max(made[Stage][1] - own, 0.0), 1e3 * own,
                1e3 * max(made[EverythingOn][1] - all_on, 0.0), 1e3 * all_on)


def first_frame(kind: type[Stage], source: Source, values: dict) -> tuple[Stage, float]:
    """A stage, and the seconds from its texts to the end of its first frame; nothing is taken from earlier ones."""
    ctx = context()
    before, ctx.extra = ctx.extra, {"pixel": pixel(ctx)}  # no program but what is compiled now
    try:
        start = time.perf_counter()
        stage = kind(ctx, source, values.get("triangles"), values)
        frame(stage, values)
        return stage, time.perf_counter() - start
    finally:
        ctx.extra = before


def frame(stage: Stage, values: dict) -> float:
    """Seconds of one frame, ended with glFinish: before it nothing need have been drawn."""
    start = time.perf_counter()
    stage.draw(values, stage.scene.camera, SIZE, THEMES["dark"], fine=False, counted=False)
    stage.ctx.finish()
    return time.perf_counter() - start


def held(stage: Stage) -> tuple[int, int]:
    """What a stage keeps on the graphics card in kB, and the texels of its constant data."""
    texels = sum(texture.width * texture.height for _, texture in stage.data.values())
    buffers = sum(data[0].size + (indices.size if indices else 0) for data, indices in stage.geometry.values())
    textures = sum(texture.width * texture.height * texture.components * 4 for _, texture in stage.data.values())
    targets = sum(4 * part.width * part.height for part in stage.picture.parts.values())  # 4 bytes a pixel, depth too
    return (buffers + textures + targets) // 1024, texels


def samples(values: dict) -> int:
    return int(4 ** values["level"] if "level" in values else values.get("samples", 0))
