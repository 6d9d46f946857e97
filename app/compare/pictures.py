"""Both renderers' radiance of the same mesh under the same light, in floats, and how far they are apart.

A far lamp gives pi W/m^2 to what faces it, so that a white matt surface there has the radiance 1. Off silhouettes: a
pixel whose 5 x 5 neighbours are all on the mesh, with no jump of depth between them, and no crease between the 3 x 3.
"""

from dataclasses import dataclass, replace
from math import ceil, cos, log2, pi, radians, sin, tan

import numpy as np

from app import camera as orbit
from app import shader
from app.compare.material import Material
from app.gpu.context import context
from app.gpu.pick import raw
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Scene, Surface
from app.mesh_edges import corner_normals
from app.problem import Problem
from app.reference import Light, Shot, radiance, render
from app.theme import THEMES

DARKEST = 1e-4  # radiance below which pyrender's 8 bits need not tell
BOUND = 0.007, 1e-4  # aligned models agree to so much of the radiance, and to so much: what 8 bits round is 0.6 %
CREASE = 0.9  # the cosine between normals of neighbouring pixels below which an edge lies between them
VIEW = Camera(azimuth=-50.0, elevation=22.0)
FAR, ROOM = 6.0, 1.04  # the eye's distance, and how much wider than the mesh the picture is

OURS = """
uniform vec3 to_light;
vec3 mesh_point(int surface, vec3 p) {{ return p; }}
vec4 mesh_value(int surface, vec3 p, int face) {{ return vec4(corner_normal(p, face), 0.0); }}
vec3 shade(Surface s) {{
    vec3 n = normalize(s.value.xyz), l = to_light, v = s.v;
    if (dot(n, s.normal) < 0.0) n = -n;
    return {radiance};
}}
"""
NORMAL = Scene(glsl='#include "stage/corner_normal.glsl"\n' + OURS.format(radiance="n + 0.0 * l + 0.0 * v"),
               surfaces=(Surface("mesh", mesh=True),))


@dataclass(frozen=True)
class Difference:
    """How far two pictures are apart, in radiance, over the pixels off silhouettes."""

    pixels: int
    rmse: float
    most: float
    p999: float  # 99.9 % of the pixels' channels are nearer than this
    relative: float  # 99.9 % of those that are brighter than 0.001 are nearer than this share of themselves


@dataclass(frozen=True)
class Compared:
    ours: np.ndarray  # (height, width, 3) radiance
    aligned: np.ndarray  # our GLSL of glTF's model
    theirs: np.ndarray
    inside: np.ndarray  # (height, width) off silhouettes
    difference: Difference
    agreement: Difference  # of the aligned one
    within: bool  # whether every pixel of it keeps BOUND
    to_light: np.ndarray


def to_light(values: dict, view: Camera) -> np.ndarray:
    """Where the step's light stands: its normal is turned up from the eye by theta_v, the light from there by theta_l
    and phi; without them up and to the left of the eye."""
    eye = orbit.position(replace(view, target=(0, 0, 0)))
    eye = eye / np.linalg.norm(eye)
    up = np.array([0, 0, 1.0]) - eye[2] * eye
    up = up / np.linalg.norm(up) if np.linalg.norm(up) > 1e-9 else np.array([0, 1.0, 0])
    aside = np.cross(up, eye)
    if not {"theta_l", "theta_v", "phi"} <= set(values):
        return cos(pi / 4) * eye + sin(pi / 4) * (0.8 * up - 0.6 * aside)
    tilt, turn, theta = values["theta_v"], values["phi"], values["theta_l"]
    picked, along = cos(tilt) * eye + sin(tilt) * up, sin(tilt) * eye - cos(tilt) * up
    return cos(theta) * picked + sin(theta) * (cos(turn) * along - sin(turn) * aside)


def around(view: Camera, triangles: np.ndarray) -> Camera:
    """The step's direction of view, of a mesh about the origin."""
    wide = 2 * np.degrees(np.arcsin(np.linalg.norm(triangles, axis=-1).max() / FAR)) * ROOM
    return replace(view, distance=FAR, target=(0.0, 0.0, 0.0), field_of_view=wide)


def scene(function: str, arguments: dict, coloured: bool, times_cosine: bool) -> Scene:
    """Our GLSL: a mesh with that reflectance, its arguments written as numbers."""
    include, signature = shader.catalogue()[function]

    def written(name: str, kind: str, channel: int) -> str:
        if name in ("n", "l", "v"):
            return name
        given = channel if name == "channel" else arguments[name]
        given = given[channel] if isinstance(given, tuple) else given
        return str(int(given)) if kind == "int" else f"{float(given):.9e}"

    calls = [f"{function}({', '.join(written(arg.name, arg.type, channel) for arg in signature.args)})"
             for channel in range(3)]
    value = f"vec3({', '.join(calls)})" if coloured else f"vec3({calls[0]})"
    value = f"{pi:.9f} * {value}" + (" * max(dot(n, l), 0.0)" if times_cosine else "")
    text = f'#include "{include}"\n#include "stage/corner_normal.glsl"\n' + OURS.format(radiance=value)
    return Scene(glsl=text, surfaces=(Surface("mesh", mesh=True),))


def drawn(what: Scene, triangles: np.ndarray, light: np.ndarray, view: Camera, size: tuple[int, int]
          ) -> tuple[np.ndarray, np.ndarray]:
    """Radiance, 0 where there is no mesh, and its points (height, width, 3), NaN there."""
    stage = Stage(context(), Source(what, "app/compare/pictures.py"), triangles)
    try:
        found, point, _ = raw(stage, {"to_light": tuple(light)}, view, THEMES["dark"], size)
    finally:
        stage.release()
    on = found[..., 3:] > 0.5
    return np.where(on, found[..., :3], 0).astype(float), np.where(on, point[..., :3], np.nan).astype(float)


def compare(of: Material, triangles: np.ndarray, values: dict, view: Camera = VIEW, size: tuple[int, int] = (512, 512)
            ) -> Compared:
    view = around(view, triangles)
    light, function = to_light(values, view), of.model.term.function
    normals, points = drawn(NORMAL, triangles, light, view, size)
    ours, _ = drawn(scene(function, of.arguments, of.coloured, not of.model.is_shading), triangles, light, view, size)
    gltf = {"base_colour": of.colour, "metallic": of.metallic, "roughness": of.roughness}
    aligned, _ = drawn(scene("shading_gltf", gltf, True, False), triangles, light, view, size)
    brightest = max(float(np.nan_to_num(aligned).max()), DARKEST)
    exposures = tuple(0.9 / brightest * 2.0**k for k in range(max(1, ceil(log2(brightest / DARKEST)))))
    shot = Shot(triangles, corner_normals(triangles), of.colour, of.metallic, of.roughness,
                Light(at=tuple(light), strength=pi), view, size, smooth=False, exposures=exposures)  # type: ignore[arg-type]
    picture, = render(shot)
    theirs = radiance(picture, exposures)
    inside = off_silhouettes(points, normals, view, size) & (picture.depth > 0)
    if not inside.any():
        raise Problem("the mesh is so thin from here that every pixel of it is at an edge; turn the view.")
    apart, most = np.abs(aligned - theirs), np.abs(theirs)
    within = bool((apart <= BOUND[0] * most + BOUND[1])[inside].all())
    return Compared(ours, aligned, theirs, inside, difference(ours, theirs, inside),
                    difference(aligned, theirs, inside), within, light)


def difference(ours: np.ndarray, theirs: np.ndarray, inside: np.ndarray) -> Difference:
    a, b = ours[inside], theirs[inside]
    apart = np.abs(a - b)
    bright = b > 1e-3
    share = np.quantile((apart / np.where(bright, b, 1))[bright], 0.999) if bright.any() else 0.0
    return Difference(int(inside.sum()), float(np.sqrt(np.mean(apart**2))), float(apart.max()),
                      float(np.quantile(apart, 0.999)), float(share))


def off_silhouettes(points: np.ndarray, normals: np.ndarray, view: Camera, size: tuple[int, int]) -> np.ndarray:
    """Where the surface goes on for two pixels around: no end, no jump of 20 pixels in depth, no crease."""
    depth = np.linalg.norm(points - orbit.position(view), axis=-1)
    pixel = 2 * FAR * tan(radians(view.field_of_view) / 2) / min(size)
    near = neighbours(depth, 2)
    with np.errstate(invalid="ignore"):
        on = np.isfinite(near).all(0) & (near.max(0) - near.min(0) < 20 * pixel)
    return on & (np.einsum("khwi,hwi->khw", neighbours(normals, 1), normals) > CREASE).all(0)


def neighbours(picture: np.ndarray, far: int) -> np.ndarray:
    """(k, height, width, ...): the picture shifted by up to so many pixels each way, NaN beyond its edges."""
    height, width = picture.shape[:2]
    padded = np.pad(picture, [(far, far), (far, far)] + [(0, 0)] * (picture.ndim - 2), constant_values=np.nan)
    return np.stack([padded[i:i + height, j:j + width] for i in range(2 * far + 1) for j in range(2 * far + 1)])
