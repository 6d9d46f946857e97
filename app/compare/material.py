"""A step's material in the words of glTF: base colour, metallic, roughness. Arguments of a model are known by name."""

from dataclasses import dataclass
from math import sqrt

import numpy as np

from app import optics
from app.catalog import LoadedStep, steps
from app.lesson import Model, Term
from app.optics.beckmann import m_from_exponent
from app.optics.gltf import COPPER, DIELECTRIC, alpha_gltf, roughness_gltf
from app.optics.materials import INSULATORS, f_material
from app.optics.matter import matter_body
from app.problem import Usage
from app.terms import bound

MATT = Model("matt", Term("brdf_lambert", {"rho": 0.5}), "exact")  # a mesh without a material
KNOWN = {"n", "l", "v", "channel", "m", "alpha", "exponent", "f0", "rho", "k_d", "k_s", "material", "coupling",
         "geometry", "metallic", "roughness", "mapped"}


@dataclass(frozen=True)
class Material:
    model: Model  # ours
    arguments: dict  # of its twin, without n, l, v and channel
    colour: tuple[float, float, float]  # glTF's, linear
    metallic: float
    roughness: float

    @property
    def coloured(self) -> bool:
        return "channel" in optics.arguments(self.model.term.function)


def model_of(found: LoadedStep) -> Model | None:
    """What is compared: a step's first model, or matt grey for a mesh that has none."""
    if found.step.models:
        return found.step.models[0]
    return MATT if any(surface.mesh for surface in found.step.scene.surfaces) else None


def unlike(found: LoadedStep) -> str:
    """Why a step cannot be compared; "" where it can."""
    model = model_of(found)
    if model is None:
        return "it has no model of matter"
    given = optics.arguments(model.term.function)
    coloured = "material" in given or "mapped" in given
    strange = [name for name in given if name not in KNOWN or (name == "channel" and not coloured)]
    if strange:
        return f"{model.term.function} depends on {strange[0]}, for which glTF's materials have no word"
    return ""


def material(found: LoadedStep, values: dict) -> Material:
    """The step's model at its values, and glTF's nearest; Usage where there is none."""
    why = unlike(found)
    if why:
        others = ", ".join(step.id for step in steps() if not unlike(step))
        raise Usage(f"{found.id} cannot be compared with pyrender: {why}. These can: {others}.")
    model = model_of(found)
    assert model is not None
    given = bound(model.term, {"channel": 0, **values}, n=0, l=0, v=0)
    given = {name: value for name, value in given.items() if name not in ("n", "l", "v", "channel")}
    colour, metallic = share(given)
    return Material(model, given, colour, metallic, roughness(given))


def roughness(given: dict) -> float:
    """alpha = m: the same peak of D. What is matt all through has 1."""
    if "roughness" in given:
        return float(given["roughness"])
    width = given.get("m", given.get("alpha"))
    if width is None and "exponent" in given:
        width = m_from_exponent(given["exponent"])
    return 1.0 if width is None else float(roughness_gltf(width))


def share(given: dict) -> tuple[tuple[float, float, float], float]:
    """Base colour and metallic. What is all mirror is a metal; a body keeps its colour, and gets F0 = 0.04."""
    if "mapped" in given:
        return three(COPPER), float(given["metallic"])
    if "material" in given:
        row = int(given["material"])
        if row >= INSULATORS:
            return three(np.clip(f_material(1.0, row), 0, 1)), 1.0
        return three(matter_body(row, np.arange(3)) / (1 - DIELECTRIC)), 0.0
    body, mirror = given.get("rho", given.get("k_d", 0.0)), given.get("f0", given.get("k_s", 0.0))
    if body == 0 and mirror > 0:
        return three(mirror), 1.0
    return three(min(1.0, body / (1 - DIELECTRIC))), 0.0


def three(colour) -> tuple[float, float, float]:
    r, g, b = np.broadcast_to(np.asarray(colour, float), 3).tolist()
    return r, g, b


def slope(given: dict) -> float | None:
    """Our RMS slope m, whatever the model calls it."""
    if "exponent" in given:
        return sqrt(2 / (given["exponent"] + 2))
    if "mapped" in given:
        return given["roughness"] if given["mapped"] == 0 else float(alpha_gltf(given["roughness"]))
    return given.get("m", given.get("alpha"))
