"""How much light a flat boundary between two media reflects: the Fresnel term, exact and approximated.

`eta` is the index of the far side over that of the near side (n_t / n_i; below 1 from inside); with `k` it is the
complex index of a metal. `l_dot_h` is the cosine at the facet, between the light and the facet's normal.
"""

import numpy as np

from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(24)


def far_cosine_squared(l_dot_h, eta):
    """The square of eta times the cosine on the far side; below 0 there is no such ray: total reflection.

    (eta - 1)(eta + 1) + l_dot_h^2; from inside eta^2 - (1 - l_dot_h)(1 + l_dot_h), which is the same

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...). Errors: none. Source: Snell's law.
    """
    c, eta = np.broadcast_arrays(np.asarray(l_dot_h, float), np.asarray(eta, float))
    return np.where(eta < 1, eta * eta - (1 - c) * (1 + c), (eta - 1) * (eta + 1) + c * c)[()]


def _cosines(l_dot_h, eta):
    """c, eta, q = eta^2 - 1, g^2 = q + c^2."""
    c, eta = np.broadcast_arrays(np.asarray(l_dot_h, float), np.asarray(eta, float))
    return c, eta, (eta - 1) * (eta + 1), far_cosine_squared(c, eta)


def f_dielectric_s(l_dot_h, eta):
    """The share reflected of light polarised across the plane of incidence (s).

    r^2, r = q / (c + g)^2, q = (eta - 1)(eta + 1), g = sqrt(q + c^2), c = l_dot_h; 1 where q + c^2 <= 0.
    Near grazing |r| = 1 - 2 min(c, g) / (c + g), the same with fewer roundings.

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...) 0 .. 1. Errors: none; nothing cancels but eta - 1.
    Source: Fresnel 1823, rationalised; deck, Fresnel Term (2).
    """
    c, eta, q, g2 = _cosines(l_dot_h, eta)
    g = np.sqrt(np.maximum(g2, 0))
    least, total = np.minimum(c, g), np.where(g2 > 0, c + g, 1)
    r = np.where(4 * least < total, 1 - 2 * least / total, q / (total * total))
    return np.where(g2 > 0, r * r, 1.0)[()]


def f_dielectric_p(l_dot_h, eta):
    """The share reflected of light polarised along the plane of incidence (p); none at Brewster's angle.

    r^2, r = q (eta^2 c^2 - (1 - c^2)) / (eta^2 c + g)^2, q and g as in f_dielectric_s; 1 where q + c^2 <= 0

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...) 0 .. 1. Errors: none; near its zero as exact as its inputs.
    Source: Fresnel 1823, rationalised; deck, Fresnel Term (2).
    """
    c, eta, q, g2 = _cosines(l_dot_h, eta)
    ec2 = eta * eta * c * c
    zero = np.where(eta < 1, ec2 - (1 - c) * (1 + c), ec2 + c * c - 1)
    far, g = eta * eta * c, np.sqrt(np.maximum(g2, 0))
    least, total = np.minimum(far, g), np.where(g2 > 0, far + g, 1)
    r = np.where(4 * least < total, 1 - 2 * least / total, q * zero / (total * total))
    return np.where(g2 > 0, r * r, 1.0)[()]


def f_dielectric(l_dot_h, eta):
    """The share of unpolarised light that a transparent medium reflects.

    (f_dielectric_s + f_dielectric_p) / 2

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...) 0 .. 1; 1 at grazing, and from inside beyond the critical angle.
    Errors: none. Source: Fresnel 1823; deck, Fresnel Term (1), (2).
    """
    return 0.5 * (f_dielectric_s(l_dot_h, eta) + f_dielectric_p(l_dot_h, eta))


def f_dielectric_naive(l_dot_h, eta):
    """The same as textbooks print it, by the cosine on the far side: no number where that has none.

    ((c - eta g)^2 / (c + eta g)^2 + (eta c - g)^2 / (eta c + g)^2) / 2, g = sqrt(1 - (1 - c^2) / eta^2)

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...); NaN in total reflection, and near eta = 1 it loses its digits.
    Errors: those. Source: Fresnel 1823 with Snell's law.
    """
    c, eta = np.broadcast_arrays(np.asarray(l_dot_h, float), np.asarray(eta, float))
    with np.errstate(invalid="ignore"):
        g = np.sqrt(1 - (1 - c * c) / (eta * eta))
        s, p = (c - eta * g) / (c + eta * g), (eta * c - g) / (eta * c + g)
    return (0.5 * (s * s + p * p))[()]


def t_dielectric(l_dot_h, eta):
    """The share of unpolarised light that enters a transparent medium; with f_dielectric it makes 1.

    2 c g (1 / (c + g)^2 + eta^2 / (eta^2 c + g)^2), g = sqrt(q + c^2); 0 where q + c^2 <= 0

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...) 0 .. 1. Errors: none; a product, where 1 - F would cancel.
    Source: Fresnel 1823; deck, Fresnel Term (1).
    """
    c, eta, _, g2 = _cosines(l_dot_h, eta)
    g = np.sqrt(np.maximum(g2, 0))
    far = np.where(g2 > 0, eta * eta * c + g, 1)
    near = np.where(g2 > 0, c + g, 1)
    return (2 * c * g * (1 / (near * near) + (eta / far) ** 2))[()]


def f_conductor(l_dot_h, eta, k):
    """The share of unpolarised light that a metal of complex index eta + i k reflects.

    s2 = (1 - c)(1 + c), t0 = (eta - k)(eta + k) - s2, r = hypot(t0, 2 eta k), A = sqrt((r + t0) / 2) or, where t0 < 0,
    eta k / sqrt((r - t0) / 2); Rs = (r + c^2 - 2 A c) / (r + c^2 + 2 A c),
    Rp = Rs (c^2 r + s2^2 - 2 A c s2) / (c^2 r + s2^2 + 2 A c s2); (Rs + Rp) / 2

    l_dot_h (...) 0 .. 1, eta > 0, k >= 0 (...). Returns (...) 0 .. 1; with k = 0 it is f_dielectric. Errors: none for
    metals; Rs and Rp are differences, which cancel where next to nothing is reflected.
    Source: Lagarde 2013, Memo on Fresnel equations, with the root that does not cancel; deck, Fresnel Term (2).
    """
    c, eta, k = np.broadcast_arrays(*(np.asarray(x, float) for x in (l_dot_h, eta, k)))
    s2 = (1 - c) * (1 + c)
    t0 = (eta - k) * (eta + k) - s2
    r = np.hypot(t0, 2 * eta * k)
    root = np.sqrt(0.5 * (r + np.abs(t0)))
    a = np.where(t0 < 0, eta * k / np.where(root > 0, root, 1), root)
    t1, t2 = r + c * c, 2 * a * c
    grazing = t1 + t2 <= 0
    r_s = np.where(grazing, 1.0, (t1 - t2) / np.where(grazing, 1, t1 + t2))
    t3, t4 = c * c * r + s2 * s2, t2 * s2
    below = t3 + t4 <= 0
    ratio = np.where(below, 1.0, (t3 - t4) / np.where(below, 1, t3 + t4))
    return (0.5 * r_s * (1 + ratio))[()]


def f_conductor_naive(l_dot_h, eta, k):
    """The share that a metal would reflect if its index had no imaginary part: a glass of that index.

    f_dielectric(l_dot_h, eta)

    The arguments of f_conductor; k is not used. Returns (...) 0 .. 1. Errors: all of what k does, 0.9 for aluminium.
    Source: Fresnel 1823.
    """
    return f_dielectric(*np.broadcast_arrays(np.asarray(l_dot_h, float), np.asarray(eta, float), k)[:2])


def f_schlick(l_dot_h, f0):
    """Schlick's fit of the Fresnel term from one number, the share reflected at normal incidence.

    f0 + (1 - f0) (1 - l_dot_h)^5

    l_dot_h (...) 0 .. 1, f0 (...) 0 .. 1. Returns (...) 0 .. 1. Errors: a fit; off by up to .06 (water), .18 (iron).
    Source: Schlick 1994; deck, Fresnel Term (8).
    """
    x = np.maximum(0.0, 1 - np.asarray(l_dot_h, float))
    x2 = x * x
    return f0 + (1 - np.asarray(f0, float)) * x2 * x2 * x


def f_f82(l_dot_h, f0, f82):
    """Schlick's fit bent so that it passes through a second number, the share at l_dot_h = 1/7 (about 82 degrees).

    f_schlick - b c (1 - c)^6, b = (f_schlick(1/7) - f82) / (1/7 (6/7)^6)

    l_dot_h (...), f0, f82 (...) 0 .. 1. Returns (...). Errors: a fit; off by up to .02 for the five metals. It may
    leave 0 .. 1 for an f82 far from Schlick's; it is not clamped here.
    Source: Hoffman 2019, Fresnel Equations Considered Harmful; Kutz et al. 2021.
    """
    c = np.minimum(1.0, np.asarray(l_dot_h, float))
    x = 1 - c
    x3 = x * x * x
    b = (f_schlick(1 / 7, f0) - f82) * (7 * (7 / 6) ** 6)
    return f_schlick(c, f0) - b * c * x3 * x3


def f0_from_eta(eta):
    """The share reflected at normal incidence.

    ((eta - 1) / (eta + 1))^2

    eta (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Fresnel 1823; deck, Fresnel Term (7).
    """
    eta = np.asarray(eta, float)
    return ((eta - 1) / (eta + 1)) ** 2


def eta_from_f0(f0):
    """The index above 1 that reflects a given share at normal incidence.

    (1 + sqrt(f0)) / (1 - sqrt(f0)) = (1 + sqrt(f0))^2 / (1 - f0)

    f0 (...) 0 .. below 1. Returns (...) >= 1. Errors: none. Source: Fresnel 1823; deck, Fresnel Term (7).
    """
    f0 = np.asarray(f0, float)
    return (1 + np.sqrt(f0)) ** 2 / (1 - f0)


def brewster_angle(eta):
    """The angle at which light polarised along the plane of incidence is not reflected.

    atan(eta)

    eta (...) > 0. Returns (...) rad. Errors: none. Source: Brewster 1815.
    """
    return np.arctan(np.asarray(eta, float))


def critical_angle(eta):
    """The angle beyond which light inside a denser medium (eta < 1) is reflected wholly; 90 degrees for eta >= 1.

    asin(eta) = atan2(eta, sqrt((1 - eta)(1 + eta)))

    eta (...) > 0. Returns (...) rad. Errors: none. Source: Snell's law.
    """
    eta = np.minimum(np.asarray(eta, float), 1.0)
    return np.arctan2(eta, np.sqrt((1 - eta) * (1 + eta)))


def refracted_cosine(l_dot_h, eta):
    """The cosine of the ray that enters, to the normal on the far side; 0 where none does.

    sqrt(max(0, (eta - 1)(eta + 1) + l_dot_h^2)) / eta

    l_dot_h (...) 0 .. 1, eta (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Snell's law.
    """
    _, eta, _, g2 = _cosines(l_dot_h, eta)
    return (np.sqrt(np.maximum(g2, 0)) / eta)[()]


def f_average_schlick(f0):
    """Schlick's fit averaged over the cosine-weighted hemisphere.

    2 int f_schlick mu dmu = f0 + (1 - f0) / 21

    f0 (...) 0 .. 1. Returns (...) 0 .. 1. Errors: none. Source: Schlick 1994, integrated.
    """
    f0 = np.asarray(f0, float)
    return f0 + (1 - f0) / 21


def f_average_dielectric(eta):
    """The share reflected of diffuse light: f_dielectric averaged over the cosine-weighted hemisphere.

    2 int f_dielectric mu dmu with mu = sqrt(q) sinh u, in which the s part is (eta - 1)(3 eta + 1) / (3 (eta + 1)^2)
    and the p part is smooth: 24 nodes in v, u = U v^2. From inside: 1 - (1 - value(1 / eta)) eta^2.

    eta (...) 0.1 .. 10. Returns (...) 0 .. 1. Errors: none seen beyond rounding. Source: Walsh 1926; d'Eon 2021.
    """
    eta = np.asarray(eta, float)
    n = np.maximum(eta, 1 / eta)
    outside = 0.5 * ((n - 1) * (3 * n + 1) / (3 * (n + 1) ** 2) + _average_p(n))
    return np.where(eta < 1, 1 - (1 - outside) / (n * n), outside)[()]


def _average_p(n):
    n = np.asarray(n, float)[..., None]
    q = (n - 1) * (n + 1)
    top = 0.5 * np.log((n + 1) / np.where(n > 1, n - 1, 1))
    u, du = top * _NODES**2, top * 2 * _NODES * _WEIGHTS
    c, g = np.sqrt(q) * np.sinh(u), np.sqrt(q) * np.cosh(u)
    r = q * ((n * n + 1) * c * c - 1) / np.where(n > 1, n * n * c + g, 1) ** 2
    return np.sum(2 * r * r * c * g * du, -1)


