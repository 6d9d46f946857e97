"""Filtering of normals: what the length of their mean says of their spread."""

import numpy as np

_TERMS = (1 / 3, 1 / 45, 2 / 945, 1 / 4725, 2 / 93555, 1382 / 638512875, 4 / 18243225, 3617 / 162820783125,
          87734 / 38979295480125)  # of coth x - 1/x, with alternating signs


def toksvig_exponent(normal_length, exponent):
    """The Phong exponent of a highlight over a spread of normals, from the length of their mean.

    e L / (L + e (1 - L))

    normal_length L (...), 0 .. 1, exponent e >= 0 (...). Returns (...); 0 where L and e are 0. Errors: none.
    Source: Toksvig 2005, Mipmapping Normal Maps.
    """
    length, exponent = np.asarray(normal_length, float), np.asarray(exponent, float)
    below = length + exponent * (1 - length)
    return np.where(below > 0, exponent * length / np.where(below > 0, below, 1), 0.0)[()]


def vmf_mean_length(kappa):
    """The length of the mean of unit vectors spread as exp(kappa cos): a von Mises-Fisher distribution.

    coth kappa - 1 / kappa; for kappa < 1/2, where this cancels, its series kappa/3 - kappa^3/45 + 2 kappa^5/945 - ...

    kappa >= 0 (...). Returns (...), 0 .. 1. Errors: none. Source: Langevin 1905, Magnetisme et theorie des electrons.
    """
    kappa = np.asarray(kappa, float)
    small = kappa < 0.5
    q, tail = np.where(small, kappa, 0) ** 2, 0.0
    for term in reversed(_TERMS):
        tail = term - q * tail
    large = np.where(small, 1, kappa)
    return np.where(small, kappa * tail, 1 / np.tanh(large) - 1 / large)[()]
