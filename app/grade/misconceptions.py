"""Known misconceptions: a wrong answer that matches one of their variants is told its name and what to look at.

One speaks when the answers match its variant at 95 % of the points where the variant clearly differs from the right
value; at most two speak, the most specific first. It is feedback only: marks do not depend on it.
"""

import math
from collections.abc import Callable

import numpy as np

from app.grade.agree import NOTHING, Truth, agrees, truth
from app.grade.assignment import Task, own_module
from app.grade.result import Suspect
from app.grade.variants import VARIANTS
from app.tolerance import norm

MATCH, RIVAL = 0.95, 0.01  # a second one must match nearly as well as the best
CLEAR, CLOSE = 0.01, 1e-3  # relative: clearly different from the right value; the same as the variant
FEWEST = 3  # points at which it must differ
MOST = 2
MANY = 4000  # points that are looked at

MESSAGES = {  # the most specific first
    "lambert_no_pi": "Diffuse BRDF is albedo / π: the cosine integrates to π.",
    "brdf_has_cosine": "A BRDF holds no cosine; the reflectance equation adds it.",
    "cosine_missing": "A tilted surface receives less: multiply by n·l.",
    "no_horizon_clamp": "Light below the horizon gives 0.",
    "kd_plus_ks": "More light leaves than arrives: what the coat mirrors does not reach the body.",
    "reflect_sign": "reflect() wants the ray towards the surface: reflect(-l, n).",
    "rv_not_clamped": "Clamp r·v to 0 before the power.",
    "phong_for_blinn": "Blinn uses n·h; your lobe, of r·v, is narrower.",
    "h_not_normalised": "Normalise h: l + v is up to 2 long.",
    "ndf_as_brdf": "(n + 2) / 2π normalises the facet distribution D, not the BRDF's lobe.",
    "lobe_shortcut": "(n + 8) / 8π is an approximation; the exact factor is asked.",
    "beckmann_no_pi": "The normalised D has π below.",
    "beckmann_quarter": "1/4 for 1/π is an older convention; the integral of D cos must be 1.",
    "beckmann_plus": "The exponent is negative.",
    "beckmann_sin": "The exponent has the tangent, not the sine: tan² = (1 - c²) / c².",
    "m_not_squared": "m is squared in the exponent.",
    "m_as_roughness": "m is the slope itself: do not square it first.",
    "alpha_is_roughness": "Mind what α is: here it is roughness squared already, the width itself.",
    "degrees": "Angles are in radians, and solid angles in steradians.",
    "unstable_form": "The right formula in a form that loses its digits: find one that subtracts nothing nearly equal, "
                     "as (1 - c)(1 + c) for 1 - c².",
    "schlick_macro": "Fresnel acts on the facet: use l·h, not n·v or n·l.",
    "schlick_no_complement": "The factor (1 - f0) is missing: at grazing F is 1.",
    "schlick_inverted": "F rises towards grazing: the power is of 1 - l·h.",
    "f0_not_squared": "f0 is that ratio squared.",
    "f0_srgb": "f0 is linear; do not encode it as sRGB.",
    "eta_inverted": "η = n_t / n_i: the far side over the near side.",
    "g_inverted": "The ratio is upside down.",
    "g_max": "G takes the smallest term.",
    "g_unbounded": "G never exceeds 1: the 1 belongs into the minimum.",
    "g_one_sided": "Masking and shadowing: both n·v and n·l can block.",
    "ct_one_over_pi": "4/π too bright: a D with π goes with 1/4, not with 1/π.",
    "ct_no_denominator": "Divide by n·l and n·v.",
    "no_inverse_square": "It falls with r².",
    "light_reversed": "l points to the light: p - x, not x - p.",
    "lm_as_cd": "I = Φ / 4π if it is even to all sides: lumen is not candela.",
    "cd_as_lm": "Candela is already per steradian: no 4π.",
    "watt_as_lumen": "Lumen = watt × efficacy (at most 683 lm/W).",
    "candela_squared": "The table's value is multiplied by itself.",
    "spot_full_angle": "Hotspot and falloff are half angles, from the axis.",
    "spot_sign": "l points to the light, d along the beam: the cosine is -l·d.",
    "spot_no_clamp": "Clamp to 0 and 1.",
    "cone_full_angle": "θ is the half-angle already.",
    "patch_no_cosine": "Project the patch on the sphere: a tilted one is seen smaller, by the cosine.",
    "sphere_area": "Only the disk of a far sphere is seen, not its surface: π r² / d².",
    "encoded": "Return linear values: no power 1/2.2.",
}
FACTORS = {"π": math.pi, "1/π": 1 / math.pi, "2": 2.0, "1/2": 0.5, "4": 4.0, "1/4": 0.25, "4π": 4 * math.pi,
           "1/4π": 0.25 / math.pi, "2π": 2 * math.pi, "1/2π": 0.5 / math.pi, "4/π": 4 / math.pi, "π/4": math.pi / 4,
           "-1": -1.0, "180/π": 180 / math.pi, "π/180": math.pi / 180, "683": 683.0, "1/683": 1 / 683}


def known(task: Task) -> dict[str, tuple[str, tuple[Callable, ...]]]:
    """The misconceptions of a function: id -> (message, its variants), most specific first."""
    found = {}
    rows = VARIANTS if task.own is None else getattr(own_module(task.own), "MISCONCEPTIONS", {})
    for name in (*MESSAGES, *(name for name in rows if name not in MESSAGES)):
        given = rows.get(name, {}).get(task.function)
        if given is not None:
            message = MESSAGES.get(name) or str(rows[name].get("message", name.replace("_", " ")))
            found[name] = message, given if isinstance(given, tuple) else (given,)
    return found


def suspects(task: Task, language: str, args: dict[str, np.ndarray], values: np.ndarray) -> list[Suspect]:
    """What wrong answers look like."""
    if len(values) > MANY:  # evenly among all: a name is told by a few thousand as well
        every = np.linspace(0, len(values) - 1, MANY).astype(int)
        args, values = {name: x[every] for name, x in args.items()}, values[every]
    if np.all(values == values[0]):
        return []  # a constant is no formula, and would match what is 0 nearly everywhere
    right = truth(task, args, language)
    found = []
    for order, (name, (message, variants)) in enumerate(known(task).items()):
        share, points = 0.0, 0
        for variant in variants:
            if name == "unstable_form":
                one = pattern(variant, right, args, values, language)
            else:
                one = matched(as_kept(evaluated(variant, args), language), right, values)
            share, points = max((share, points), one)
        if share >= MATCH:
            found.append((-points, order, Suspect(name, task.function, message, round(share, 4))))
    best = max((suspect.match for *_, suspect in found), default=0.0)
    return [one for *_, one in sorted(found, key=lambda one: one[:2]) if one.match >= best - RIVAL][:MOST]


def as_kept(wrong: np.ndarray, language: str) -> np.ndarray:
    """What the language can hold of a number: float32 ends at 3e38."""
    with np.errstate(over="ignore"):
        return np.asarray(wrong, np.float32 if language == "glsl" else float).astype(float)


def evaluated(variant: Callable, args: dict[str, np.ndarray]) -> np.ndarray:
    with np.errstate(all="ignore"):
        return variant(**args)


def matched(wrong: np.ndarray, right: Truth, values: np.ndarray) -> tuple[float, int]:
    """At what share of the points where the variant clearly differs it is what was answered, and how many they are.

    Where it does not differ the answers are right: a variant that explains only half of what is wrong says nothing.
    """
    vector = wrong.ndim > 1
    size = np.maximum(right.size, norm(np.nan_to_num(wrong), vector))
    with np.errstate(all="ignore"):
        clear = ~(norm(wrong - right.value, vector) <= CLEAR * size + 10 * right.allowed)
        same = norm(values - wrong, vector) <= CLOSE * norm(wrong, vector) + 2 * right.allowed
    clear &= ~(size < NOTHING) | ~np.isfinite(norm(wrong, vector))
    strange = ~np.isfinite(norm(wrong, vector)) & ~np.isfinite(norm(values, vector))
    count = int(np.sum(clear))
    if count < FEWEST or np.mean((agrees(right, values) | same | strange)[~clear] if np.any(~clear) else 1.0) < 0.5:
        return 0.0, 0
    return float(np.mean((same | strange)[clear])), count


def pattern(form: Callable, right: Truth, args: dict[str, np.ndarray], values: np.ndarray,
            language: str) -> tuple[float, int]:
    """An unstable form has no digits to compare: the answers are wrong where it is, and right where it is right."""
    kind = np.float32 if language == "glsl" else float
    narrow = {name: x.astype(kind) for name, x in args.items()}
    lost = ~agrees(right, np.asarray(evaluated(form, narrow), float))
    wrong = ~agrees(right, values)
    vector = values.ndim > 1
    with np.errstate(all="ignore"):
        near = norm(values - right.value, vector) <= 0.02 * right.size  # digits are lost, not a factor
    calm = ~lost
    if np.sum(lost) < FEWEST or np.sum(calm) < FEWEST or np.sum(wrong) < FEWEST:
        return 0.0, 0
    share = float(np.mean((~wrong | near)[calm]))  # elsewhere it is right, or nearly
    inside = float(np.mean(lost[wrong]))  # what is wrong is where the form fails, or beside it
    return (share, int(np.sum(lost))) if inside >= 0.5 and np.mean(wrong[calm]) < 0.3 else (0.0, 0)


def factor(right: np.ndarray, values: np.ndarray, named: bool = False) -> str:
    """', all by the factor π' where wrong answers are the right ones times one number; `named`: one of FACTORS."""
    with np.errstate(all="ignore"):
        ratio = (values / right).ravel()
    ratio = ratio[np.isfinite(ratio)]
    if len(ratio) < FEWEST:
        return ""
    middle = float(np.median(ratio))
    if middle == 0 or abs(middle - 1) < CLEAR or np.mean(np.abs(ratio / middle - 1) < CLOSE) < MATCH:
        return ""
    name = next((name for name, number in FACTORS.items() if abs(middle / number - 1) < CLOSE), "")
    return "" if named and not name else f", all by the factor {name or f'{middle:.4g}'}"
