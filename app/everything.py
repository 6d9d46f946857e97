"""The yardstick of leaving out: a scene drawn by one shader that has everything on, as if it served all scenes.

Vertices, surfaces and pixels stay the scene's own; only what colours a pixel becomes glsl/display/everything.glsl.
"""

import numpy as np

from app import shader
from app.gpu.scene_programs import ScenePrograms
from app.gpu.scene_texts import SceneTexts
from app.gpu.stage import Stage
from app.gpu.stage_text import Programs, programs
from app.lesson import Scene

FEATURES = {  # what the yardstick has on -> the files of which a scene that needs it compiles something
    "a light at a point": ("punctual",),
    "a cone of light": ("spot",),
    "16 samples of an area light": ("area_light", "shape_samples", "light_samples", "light_shape"),
    "a rough matt body": ("eon", "oren_nayar"),
    "a coat over a body": ("coat", "matter"),
    "facets": ("beckmann", "ggx", "ndf", "cook_torrance"),
    "the geometry term": ("smith", "vgroove", "geometry_term"),
    "Fresnel for metals": ("fresnel", "interface", "materials"),
    "maps": ("maps",),
    "exposure and tone curve": ("exposure",),
}
MAP = np.random.default_rng(1).integers(60, 256, (64, 64, 4)).astype(np.uint8)  # a map of roughness, filtered by hand
SHADES = ("surface", "mesh")  # the programs that colour surfaces


class Texts(SceneTexts):
    def programs(self, names: tuple[str, ...] | None, known: dict | None = None, plain: bool = False) -> Programs:
        return {name: (vertex, shading() if name in SHADES else fragment)
                for name, (vertex, fragment) in super().programs(names, known, plain).items()}


class Yardstick(ScenePrograms):
    """Surfaces are coloured by the yardstick: one program for all of them, so it is compiled once."""

    kind_of_texts = Texts
    one_program = True


class EverythingOn(Stage):
    kind: type[ScenePrograms] = Yardstick

    def place(self, triangles: np.ndarray | None) -> None:
        super().place(triangles)
        if all(table.uniform != "roughness_map" for table in self.scene.tables):
            self.hold("roughness_map", MAP)


def shading(header: tuple[str, ...] = shader.DESKTOP) -> shader.Assembled:
    """What colours a pixel of any surface with everything on."""
    text = shader.read("stage/shade.frag").replace("shade(s)", "everything(s.position, s.normal, s.v)")
    before = '#include "stage/surface.glsl"\n#include "display/everything.glsl"\n'
    return shader.assemble(before + text, "everything on", header=header)


def features(scene: Scene) -> tuple[str, ...]:
    """Which of FEATURES a scene has: it compiles something of their files."""
    files = {file for pair in programs(scene).values() for part in pair if part for file in part.files}
    return tuple(name for name, of in FEATURES.items() if any(f"glsl/optics/{file}.glsl" in files for file in of))
