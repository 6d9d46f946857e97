"""A reference of one's own: what an assignment may ask that is no function of the course."""

import numpy as np


def lobe_power(n_dot_h, exponent):
    """n_dot_h^exponent, 0 where n_dot_h <= 0; n_dot_h is a cosine, its rounding is not the student's fault."""
    up = np.asarray(n_dot_h, float) > 0
    return np.where(up, np.exp(exponent * np.log(np.where(up, n_dot_h, 1.0))), 0.0)


def _not_clamped(n_dot_h, exponent):
    return np.power(n_dot_h, exponent)


MISCONCEPTIONS = {
    "rv_not_clamped": {"lobe_power": _not_clamped},
    "abs_for_max": {"message": "A cosine below 0 is behind the surface: take the larger of it and 0, not its size.",
                    "lobe_power": lambda n_dot_h, exponent: np.abs(n_dot_h) ** exponent},
}
