"""Where a value of a twin must lie, by what its name says it is; and which twins break that on purpose."""

import math

from app import optics

SIGNED, ANY = (-4 * math.pi, 4 * math.pi), (0.0, math.inf)
BOUNDS: tuple[tuple[str, tuple[float, float]], ...] = (  # the beginning of a name; the first that fits counts
    # estimates
    ("projected_solid_angle_patch_small", ANY), ("solid_angle_patch_small", ANY), ("solid_angle_cells", ANY),
    ("projected_solid_angle", (0.0, math.pi)), ("solid_angle_patch_ratio", ANY),
    *((f"solid_angle_{name}", SIGNED) for name in ("triangle_signed", "triangle_edges", "corners", "face", "mesh")),
    ("solid_angle", (0.0, 4 * math.pi)),
    # These gain light, which their lessons show
    *((f"albedo_{name}", ANY) for name in ("without_g", "oren_nayar", "coated")),
    ("f_f82", (-math.inf, math.inf)),  # a fit that may leave 0..1, as it says
    ("albedo_", (0.0, 1.0)), ("f_", (0.0, 1.0)), ("t_dielectric", (0.0, 1.0)), ("g1_", (0.0, 1.0)),
    ("vgroove", (0.0, 1.0)),
    *((start, ANY) for start in ("g_", "lambda_", "d_", "pdf_", "brdf_", "lobe_", "shading_", "irradiance_",
                                 "radiance_", "radiant_", "illuminance_", "luminance_", "luminous_",
                                 "normalisation_")),
)
ROUNDED = 1e-6  # of the largest value: angles past their end by a rounding, quadratures
ON_PURPOSE = {  # it is no number, negative or too bright somewhere, and a lesson shows that
    "brdf_flawed": "flaws are what it shows", "ratio_flawed": "flaws are what it shows",
    "hemisphere_meter": "it measures brdf_flawed", "spot_as_printed": "0/0 where both cones are one, negative beyond",
    "spot_read": "it reads spot_as_printed too", "d_beckmann_printed": "the sign of the exponent is lost",
}
STABLE = {"d_beckmann_acos_naive": "d_beckmann", "d_beside_acos_naive": "d_beside"}  # not by its name


def kind(function: str) -> str:
    """stable; naive, to lose its digits; printed, as the deck has it; or meant, with flaws on purpose."""
    if function.endswith("_naive"):
        return "naive"
    return "meant" if function in ON_PURPOSE else "printed" if "printed" in function else "stable"


def stable_of(function: str) -> str:
    """What a naive form is judged by; itself for all others."""
    return STABLE.get(function) or function.removesuffix("_naive")


def right_of(function: str) -> str:
    """What a printed formula should be, where that takes the same arguments."""
    other = function.replace("_printed", "")
    same = other != function and other in optics.names() and optics.arguments(other) == optics.arguments(function)
    return other if same else ""


def bounds(function: str) -> tuple[float, float]:
    low, high = next((ends for start, ends in BOUNDS if function.startswith(start)), (-math.inf, math.inf))
    return low, high * (1 + ROUNDED)
