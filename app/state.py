"""The state of a step as text, the same everywhere: `solid_angle/patch?distance=2.5&tilt=30&view=-50,22,6`.

Values are as `typed` reads them; `view` is the camera's azimuth, elevation (degrees) and distance. `write` gives what
differs from the step's defaults, with six significant digits: read again they are the same text, and the same value to
5e-6. The theme is no part of it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from app.catalog import LoadedStep, step
from app.lesson import Camera, Number
from app.paths import LESSONS
from app.problem import Usage, near
from app.typed import digits, number, read, show, unquoted

NEAREST, FARTHEST = 0.1, 50.0  # of the camera


@dataclass(frozen=True)
class View:
    """Where the camera stands: degrees, and a distance from the scene's target."""

    azimuth: float
    elevation: float
    distance: float

    @staticmethod
    def of(camera: Camera) -> "View":
        return View(camera.azimuth, camera.elevation, camera.distance)

    def camera(self, scene_camera: Camera) -> Camera:
        """The scene's camera, moved here."""
        return replace(scene_camera, azimuth=self.azimuth, elevation=self.elevation, distance=self.distance)


@dataclass(frozen=True)
class State:
    step: str  # the step's id
    values: dict[str, Number]  # every value of the step, internal units
    view: View


def parse(text: str, folder: Path = LESSONS) -> State:
    """A state string, or a step's bare name, as the values of every slider."""
    name, _, query = text.strip().partition("?")
    found = step(name.strip("/"), folder)
    changed, view = parse_query(query, found)
    return State(found.id, defaults(found) | changed, view or View.of(found.step.scene.camera))


def defaults(found: LoadedStep) -> dict[str, Number]:
    return {name: spec.default for name, spec in found.values.items()}


def parse_query(query: str, found: LoadedStep) -> tuple[dict[str, Number], View | None]:
    """What stands after the '?': the values it sets, and the view if it has one."""
    values: dict[str, Number] = {}
    view = None
    for part in filter(None, (part.strip() for part in query.split("&"))):
        name, _, text = (word.strip() for word in part.partition("="))
        if name == "view" and view is None:
            view = parse_view(text)
        elif name in values or name == "view":
            raise Usage(f"{name} is given twice in ?{query}; give it once.")
        else:
            values |= parse_set(part, found)
    return values, view


def parse_set(text: str, found: LoadedStep) -> dict[str, Number]:
    """`name=value`, in screen units, as one internal value."""
    name, equals, value = (word.strip() for word in text.partition("="))
    if name not in found.values:
        raise Usage(f"there is no value {name} in {found.id}.{near(name, found.values)}")
    if not equals or not value:
        raise Usage(f"{name} has no value; write {name}={show(found.values[name])}.")
    return {name: read(value, found.values[name], f"{name}={value}: {found.id}")}


def parse_view(text: str) -> View:
    numbers = [number(part, f"view={text}") for part in unquoted(text).split(",")]
    if len(numbers) != 3:
        raise Usage(f"view={text} has {len(numbers)} numbers, not azimuth, elevation and distance.")
    azimuth, elevation, distance = numbers
    if not (-90 <= elevation <= 90 and NEAREST <= distance <= FARTHEST and abs(azimuth) <= 1e6):
        raise Usage(f"view={text} is out of range: elevation goes from -90 to 90°, "
                    f"distance from {NEAREST:g} to {FARTHEST:g}.")
    return View(turned(azimuth), elevation, distance)


def turned(azimuth: float) -> float:
    """The same direction with -180 <= azimuth <= 180."""
    return azimuth if -180 <= azimuth <= 180 else (azimuth + 180) % 360 - 180


def write(found: LoadedStep, values: Mapping[str, Number], view: View | None = None) -> str:
    """The shortest state string: the values and the view that differ from the step's own."""
    parts = [f"{name}={text}" for name, spec in found.values.items()
             if name in values and (text := show(spec, values[name])) != show(spec)]
    seen, first = (",".join(map(digits, (v.azimuth, v.elevation, v.distance)))
                   for v in (view or View.of(found.step.scene.camera), View.of(found.step.scene.camera)))
    parts += [f"view={seen}"] if seen != first else []
    return found.id + ("?" + "&".join(parts) if parts else "")
