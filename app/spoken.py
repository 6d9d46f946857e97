"""How a quantity is called at a slider and an axis: short words, its symbol in plain letters, its unit."""

import re

from app.quantities import quantity

WORDS = {  # where the name itself is no word
    "theta": "angle", "phi": "azimuth", "alpha": "width", "rho": "albedo", "eta": "index", "sigma": "spread",
    "theta_l": "light's angle", "theta_v": "eye's angle", "theta_h": "angle of h", "theta_d": "angle of l from h",
    "lean_l": "light's lean", "lean_v": "eye's lean", "facet": "facet's lean", "m": "roughness",
    "k": "extinction", "k_d": "diffuse share",
    "k_s": "specular share", "kappa": "concentration", "ndf": "distribution", "lobe_scale": "lobes show",
    "f0": "head-on share", "f82": "share at 82°", "s": "", "t": "", "x": "sideways", "y": "up",
    "xi_1": "", "xi_2": "", "slope2": "", "slope": "", "tangent": "", "steep": "", "disk_x": "place on the disk",
    "x0": "left", "x1": "right", "y0": "near", "y1": "far", "d_theta": "step", "d_phi": "step around",
    "turned": "turn", "map_s": "place", "map_t": "place", "map_layers": "maps up to", "map_trap": "misread",
    "bump_slope": "bumps' slope",
    "normal_length": "normal's length", "ev100": "exposure", "curve": "tone curve", "taken": "taken as L",
    "n_dot_l": "", "n_dot_v": "", "n_dot_h": "", "l_dot_h": "", "r_dot_v": "",
}
GREEK = {"alpha": "α", "beta": "β", "theta": "θ", "varphi": "φ", "phi": "φ", "rho": "ρ", "omega": "ω", "Omega": "Ω",
         "Delta": "Δ", "eta": "η", "sigma": "σ", "lambda": "λ", "Phi": "Φ", "pi": "π", "gamma": "γ", "delta": "δ",
         "mu": "µ", "tau": "τ", "kappa": "κ", "xi": "ξ", "psi": "ψ", "cdot": "·", "tan": "tan ", "log": "log ",
         "perp": "⊥", "bar": "mean "}
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def plain(latex: str) -> str:
    r"""A symbol of the table as plain letters: \Delta\theta -> Δθ, r_0 -> r₀, \theta_v -> θv."""
    text = re.sub(r"\\([A-Za-z]+)\s*", lambda m: GREEK.get(m[1], m[1]), latex)
    text = re.sub(r"\^2", "²", text)
    text = re.sub(r"_\{?(\d+)\}?", lambda m: m[1].translate(SUBSCRIPTS), text)
    return re.sub(r"_(\S)", r"\1", re.sub(r"\s*([·²₄])\s*", r"\1", text)).replace("{", "").replace("}", "")


def said(name: str) -> str:
    """The words alone: half angle."""
    return WORDS.get(name, name.replace("_", " "))


def words(name: str) -> str:
    """half angle θ; without words of its own the symbol alone, where symbol and word are one the word alone."""
    symbol = plain(quantity(name).symbol)
    return symbol if said(name) == symbol else f"{said(name)} {symbol}".strip()


def axis_title(name: str) -> str:
    """What stands at an axis: half angle θ in °."""
    unit = quantity(name).screen_unit
    return words(name) + (f" in {unit}" if unit else "")
