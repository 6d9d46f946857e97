"""A user's own map: a PNG or JPEG as the numbers it stores, and in words how they are read.

Albedo and F0 are colours, stored as sRGB, and decoded before they are light; roughness and normals are numbers and are
read as they are. A map has four channels in bytes, its lowest row first, as t goes up; the fourth is 0 where there is
no map. A texture is sampled before it is decoded: between two texels the eye's middle is shown, not the light's.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.problem import Problem, Usage, near

COLOURS, NUMBERS = ("albedo", "f0"), ("roughness", "normal")
KINDS = (*COLOURS, *NUMBERS)
ENDINGS = (".png", ".jpg", ".jpeg")
MOST, LARGEST = 1024, 8192  # texels of a side: more are averaged; more than the second are refused
NONE = np.zeros((1, 1, 4), np.uint8)
SPOKEN = {"albedo": "albedo", "f0": "F(0)", "roughness": "roughness", "normal": "normals"}
HINTS = {"normal": ("normal", "nrm", "nor_", "bump"), "roughness": ("rough", "gloss"), "f0": ("f0", "spec", "reflect")}


@dataclass(frozen=True, eq=False)
class OwnMap:
    kind: str
    name: str
    texels: np.ndarray  # (rows, columns, 4) uint8, the lowest row first
    note: str  # what a person should know about it


def named(text: str) -> tuple[str, str]:
    """`roughness=FILE` as its two words."""
    kind, equals, path = text.partition("=")
    if not equals or not path:
        raise Usage(f"--map {text}: write a kind and a file, like --map roughness=FILE; kinds are {', '.join(KINDS)}.")
    if kind.lower() not in KINDS:
        raise Usage(f"--map {text}: there is no map {kind}.{near(kind, KINDS) or f' There are {chr(44).join(KINDS)}.'}")
    return kind.lower(), path


def guessed(path: str | Path) -> str:
    """What a dropped file is, by its name; without a hint an albedo."""
    name = Path(path).stem.lower()
    return next((kind for kind, hints in HINTS.items() if any(hint in name for hint in hints)), "albedo")


def read(kind: str, path: str | Path) -> OwnMap:
    """The map in a file; Problem in one sentence where there is none."""
    from PIL import Image, UnidentifiedImageError

    path = Path(path).expanduser()
    if path.is_dir():
        raise Problem(f"{path} is a folder; give one picture in it ({', '.join(ENDINGS)}).")
    try:
        with Image.open(path, formats=("PNG", "JPEG")) as picture:
            size = picture.size
            if max(size) > LARGEST:
                raise Problem(f"{path} has {size[0]} x {size[1]} texels; a map has at most {LARGEST} a side, so make "
                              "it smaller.")
            picture.load()
            texels, said = numbers(picture)
    except FileNotFoundError:
        raise Problem(f"there is no file {path}; give the path of a picture ({', '.join(ENDINGS)}).") from None
    except UnidentifiedImageError:
        raise Problem(f"{path} is no PNG or JPEG picture; save the map as one of them.") from None
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        why = " ".join(str(error).split())[:90]
        raise Problem(f"{path} is damaged or may not be read ({why}); save it again.") from None
    texels, more = of_kind(kind, texels)
    smaller = averaged(texels, kind)
    if smaller is not texels:
        said.append(f"averaged to {smaller.shape[1]} x {smaller.shape[0]}")
    how = "a colour: decoded from sRGB" if kind in COLOURS else "a number: read as it is"
    note = f"{path.name}, {size[0]} x {size[1]}, as {SPOKEN[kind]}, {how}" + "".join(f"; {w}" for w in [*said, *more])
    stored = np.full((*smaller.shape[:2], 4), 255, np.uint8)
    stored[..., :3] = np.round(255 * smaller)[::-1]
    stored.flags.writeable = False
    return OwnMap(kind, path.name, stored, note)


def numbers(picture) -> tuple[np.ndarray, list[str]]:
    """Stored numbers (rows, columns, 3) from 0 to 1, and what was left out of the file."""
    said: list[str] = []
    if picture.mode.startswith("I"):  # 16 bits of grey
        grey = np.asarray(picture, float) / 65535
        return np.repeat(grey[..., None], 3, -1), said
    if picture.mode in ("LA", "PA", "RGBA") or "transparency" in picture.info:
        said.append("its transparency is left out")
    return np.asarray(picture.convert("RGB"), float) / 255, said


def of_kind(kind: str, texels: np.ndarray) -> tuple[np.ndarray, list[str]]:
    """The numbers as this kind of map has them; a word where they look like another's."""
    grey = float(np.abs(texels - texels.mean(-1, keepdims=True)).max()) < 0.02
    if kind == "roughness" and not grey:
        return np.repeat(texels[..., 1:2], 3, -1), ["it has colours, so its green is taken, where glTF keeps roughness"]
    if kind == "normal":
        mean = 2 * texels.mean((0, 1)) - 1
        if grey or mean[2] < 0.3 * np.linalg.norm(mean) or mean[2] < 0.2:
            return texels, ["it does not look like a map of normals: those are mostly light blue, 0.5 0.5 1"]
    red, green, blue = texels.mean((0, 1))
    if kind in COLOURS and not grey and blue > 0.88 and abs(red - 0.5) < 0.1 and abs(green - 0.5) < 0.1:
        return texels, ["it looks like a map of normals: those come as --map normal=FILE"]
    return texels, []


def averaged(texels: np.ndarray, kind: str) -> np.ndarray:
    """At most MOST texels a side: colours are averaged as light, numbers as they are."""
    most = max(texels.shape[:2])
    if most <= MOST:
        return texels
    from PIL import Image

    from app.optics.colour import linear_to_srgb, srgb_to_linear

    size = tuple(max(1, round(n * MOST / most)) for n in texels.shape[1::-1])
    values = srgb_to_linear(texels) if kind in COLOURS else texels
    channels = [np.asarray(Image.fromarray(values[..., c].astype(np.float32)).resize(size, Image.Resampling.BOX))
                for c in range(3)]
    found = np.clip(np.stack(channels, -1).astype(float), 0, 1)
    return np.asarray(linear_to_srgb(found)) if kind in COLOURS else found
