"""A second renderer, pyrender, to hold ours against. The only pyrender, and only in a process of its own.

pyrender ends the EGL display it shares with others, so `render` starts `python -m app.reference`, sends the shots and
reads the pictures. Starting it costs one to two seconds, a further shot of the same call a few milliseconds.

What it computes (its mesh.frag) is the metallic-roughness model of glTF, with a = roughness^2:
f = (1 - F) 0.96 (1 - metallic) colour / pi + D G F / (4 nl nv + 0.001), D = GGX of width a, G = Schlick's with
k = (roughness + 1)^2 / 8, F = Schlick's of v.h from F0 = 0.04 (1 - metallic) + metallic colour; nl and nv stay above
0.001, so nothing is quite black. It shades locally: no light from other surfaces, and shadows only of a spot light, by
a shadow map, where a shot asks for them. A picture is the radiance to the power 1 / 2.2 in 8 bits.
"""

import json
import os
import subprocess
import sys
from dataclasses import asdict, dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from app import camera
from app.lesson import Camera
from app.paths import ROOT
from app.problem import Problem

TIMEOUT = 60.0
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Light:
    """Directional: irradiance `strength` on a surface that faces `at`, the direction TO the light. Point: radiant
    intensity `strength` (W/sr) at the position `at`. Spot: the same within `half_angle` (rad) about the way from
    `at` to `to`, and a hard edge. `colour` (linear) multiplies it."""

    kind: Literal["directional", "point", "spot"] = "directional"
    at: Vector = (0.0, 0.0, 1.0)
    strength: float = float(np.pi)
    colour: Vector = (1.0, 1.0, 1.0)
    to: Vector = (0.0, 0.0, 0.0)
    half_angle: float = 1.0


@dataclass(frozen=True)
class Shot:
    """A mesh, what it is made of, a light, and the eye. `normals` (F, 3, 3) make it smooth; without them it is flat."""

    triangles: np.ndarray  # (F, 3, 3), counter-clockwise seen from outside
    normals: np.ndarray | None = None
    colour: Vector = (0.5, 0.5, 0.5)  # base colour, linear
    metallic: float = 0.0
    roughness: float = 1.0
    light: Light = Light()
    camera: Camera = field(default_factory=Camera)
    size: tuple[int, int] = (512, 512)  # width, height
    background: Vector = (0.0, 0.0, 0.0)  # as on screen, 0 to 1
    two_sided: bool = True  # the inside of an open mesh is lit too, with its normal turned
    shadows: bool = False  # of a spot light: pyrender has none for a point
    smooth: bool = True  # edges; it mixes 4 samples of a pixel, and small triangles are coloured beyond their rims
    exposures: tuple[float, ...] = (1.0,)  # the light's strength is multiplied by each in turn


class Picture(NamedTuple):
    rgb: np.ndarray  # (height, width, 3) uint8, at the first exposure
    depth: np.ndarray  # (height, width) float32, along the axis of view, at one sample of the pixel; 0: nothing
    exposed: np.ndarray  # (exposures, height, width, 3) uint8


def linear(rgb: np.ndarray) -> np.ndarray:
    """Radiance from a picture's 8 bits: the inverse of what pyrender does to it."""
    return (rgb / 255.0) ** 2.2


def radiance(picture: Picture, exposures: tuple[float, ...]) -> np.ndarray:
    """(height, width, 3) at exposure 1: 8 bits say too little of the dark, and cut what is above 1, so each channel is
    taken from the largest of the (rising) exposures that does not cut it."""
    found = linear(picture.exposed[0]) / exposures[0]
    for rgb, exposure in zip(picture.exposed, exposures, strict=True):
        found = np.where(rgb < 255, linear(rgb) / exposure, found)
    return found


def render(*shots: Shot, timeout: float = TIMEOUT) -> list[Picture]:
    """The pictures of all shots, drawn by one child process; Problem if it dies, hangs or cannot draw."""
    jobs, arrays = [], []
    for shot in shots:
        corners, normals = surface(shot)
        job = {"count": len(corners), "pose": pose(shot.camera), "yfov": yfov(shot), "size": shot.size,
               "colour": shot.colour, "metallic": shot.metallic, "roughness": shot.roughness,
               "background": shot.background, "light": asdict(shot.light), "shadows": shot.shadows,
               "smooth": shot.smooth, "exposures": shot.exposures}
        jobs.append(job)
        arrays += [corners.tobytes(), normals.tobytes()]
    expected = sum((4 + 3 * len(shot.exposures)) * shot.size[0] * shot.size[1] for shot in shots)
    answer = run_child(json.dumps(jobs).encode() + b"\n" + b"".join(arrays), expected, timeout)
    pictures, at = [], 0
    for shot in shots:
        (width, height), pixels = shot.size, shot.size[0] * shot.size[1]
        depth = np.frombuffer(answer, np.float32, pixels, at).reshape(height, width)
        many, at = len(shot.exposures), at + 4 * pixels
        exposed = np.frombuffer(answer, np.uint8, 3 * many * pixels, at).reshape(many, height, width, 3)
        pictures.append(Picture(exposed[0].copy(), depth.copy(), exposed))
        at += 3 * many * pixels
    return pictures


def surface(shot: Shot) -> tuple[np.ndarray, np.ndarray]:
    """Corners and their normals, (3F, 3) float32; with two sides each triangle comes a second time, turned round."""
    triangles = np.asarray(shot.triangles, dtype=np.float64)
    if triangles.ndim != 3 or triangles.shape[1:] != (3, 3) or not len(triangles) or not np.isfinite(triangles).all():
        raise Problem("The reference renderer needs finite triangles of shape (F, 3, 3) with F > 0, "
                      f"not {triangles.shape}.")
    normals = shot.normals
    if normals is None:
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normals = np.repeat(normals[:, None] / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None, None], 3, 1)
    if shot.two_sided:
        triangles = np.concatenate([triangles, triangles[:, ::-1]])
        normals = np.concatenate([normals, -normals[:, ::-1]])
    return triangles.reshape(-1, 3).astype(np.float32), np.asarray(normals).reshape(-1, 3).astype(np.float32)


def pose(view: Camera) -> list[list[float]]:
    """Camera to world, for an eye that looks along its -z."""
    eye, azimuth = camera.position(view), np.radians(view.azimuth)
    forward = (np.asarray(view.target) - eye) / np.linalg.norm(np.asarray(view.target) - eye)
    side = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    matrix = np.eye(4)
    matrix[:3] = np.stack([side, np.cross(side, forward), -forward, eye], axis=1)
    return matrix.tolist()


def yfov(shot: Shot) -> float:
    """Vertical, in radians; a picture taller than wide keeps the horizontal one, as in `camera`."""
    width, height = shot.size
    return float(2 * np.arctan(np.tan(np.radians(shot.camera.field_of_view) / 2) * max(1.0, height / width)))


def run_child(request: bytes, expected: int, timeout: float) -> bytes:
    """What `python -m app.reference` answers; it is alone with its OpenGL, so that it can break nothing of ours."""
    environment = dict(os.environ)
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), environment.get("PYTHONPATH")]))
    if sys.platform.startswith("linux"):
        environment["PYOPENGL_PLATFORM"] = "egl"
    try:
        done = subprocess.run([sys.executable, "-m", "app.reference"], input=request, capture_output=True,
                              timeout=timeout, env=environment, check=False)
    except subprocess.TimeoutExpired:
        raise Problem(f"The reference renderer (pyrender) did not answer within {timeout:g} s and was stopped. "
                      + DOCTOR) from None
    if done.returncode or len(done.stdout) != expected:
        words = done.stderr.decode(errors="replace").strip().splitlines()
        why = f"signal {-done.returncode}" if done.returncode < 0 else words[-1] if words else "no reason given"
        raise Problem(f"The reference renderer (pyrender) ended without a picture ({why}). {DOCTOR}")
    return done.stdout


DOCTOR = "Run `halfway doctor`: it prints the command that mends it."


def draw(job: dict[str, Any], corners: np.ndarray, normals: np.ndarray) -> bytes:
    """One shot, in the child: depth and the rgb of each exposure as bytes."""
    import pyrender
    import pyrender.renderer as inside

    many = inside.glRenderbufferStorageMultisample
    if not job["smooth"]:
        inside.glRenderbufferStorageMultisample = lambda target, samples, *rest: many(target, 0, *rest)
    light, background = job["light"], job["background"]
    material = pyrender.MetallicRoughnessMaterial(
        baseColorFactor=(*job["colour"], 1.0), metallicFactor=job["metallic"], roughnessFactor=job["roughness"])
    scene = pyrender.Scene(bg_color=(*background, 1.0), ambient_light=(0.0, 0.0, 0.0))
    scene.add(pyrender.Mesh([pyrender.Primitive(positions=corners, normals=normals, material=material)]))
    strength = {"color": light["colour"], "intensity": light["strength"]}
    at, place = np.asarray(light["at"], dtype=np.float64), np.eye(4)
    if light["kind"] == "point":
        lamp = pyrender.PointLight(**strength)
    elif light["kind"] == "spot":
        place[:3, :3] = turned(at - light["to"])
        edge = light["half_angle"]
        lamp = pyrender.SpotLight(innerConeAngle=edge, outerConeAngle=edge + 1e-3, **strength)
    else:
        place[:3, :3] = turned(at)
        lamp = pyrender.DirectionalLight(**strength)
    if light["kind"] != "directional":
        place[:3, 3] = at
    scene.add(lamp, pose=place)
    eye = pyrender.PerspectiveCamera(yfov=job["yfov"], znear=camera.NEAR, zfar=camera.FAR)
    scene.add(eye, pose=np.array(job["pose"]))
    renderer = pyrender.OffscreenRenderer(*job["size"])
    try:
        flags = pyrender.RenderFlags.SHADOWS_SPOT if job["shadows"] else pyrender.RenderFlags.NONE
        found = []
        for exposure in job["exposures"]:
            lamp.intensity = exposure * light["strength"]
            rgb, depth = renderer.render(scene, flags=flags)
            found += [np.ascontiguousarray(rgb[..., :3]).tobytes()]
        return b"".join([depth.astype(np.float32).tobytes(), *found])
    finally:
        inside.glRenderbufferStorageMultisample = many
        renderer.delete()


def turned(back: np.ndarray) -> np.ndarray:
    """The axes of a light that shines along its -z, as columns; `back` is where its z goes."""
    z = back / np.linalg.norm(back)
    x = np.cross(np.eye(3)[np.argmin(np.abs(z))], z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], axis=1)


def child() -> None:
    """Shots on standard input, pictures on standard output; whatever a driver prints goes to standard error."""
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    for job in json.loads(sys.stdin.buffer.readline()):
        corners, normals = (np.frombuffer(sys.stdin.buffer.read(12 * job["count"]), np.float32).reshape(-1, 3)
                            for _ in range(2))
        out.write(draw(job, corners, normals))
    out.close()
    os._exit(0)  # past the clean-up of drivers, which may crash


if __name__ == "__main__":
    try:
        child()
    except Exception as error:
        print(f"{type(error).__name__}: {' '.join(str(error).split())}", file=sys.stderr, flush=True)
        os._exit(1)
