"""A flat boundary between two media, by the angle of the light: what it reflects, what it lets in, and where to."""

import numpy as np

from app.optics.fresnel import (
    f0_from_eta,
    f_average_schlick,
    f_dielectric,
    f_dielectric_p,
    f_dielectric_s,
    f_schlick,
    refracted_cosine,
    t_dielectric,
)


def _cosine(theta):
    return np.maximum(0.0, np.cos(np.asarray(theta, float)))


def reflected_share(theta, eta):
    """The share of unpolarised light that is reflected at an angle.

    f_dielectric(cos theta, eta)

    theta (...) rad from the normal, beyond 90 degrees as at 90; eta (...) > 0. Returns (...) 0 .. 1. Errors: none.
    Source: deck, Fresnel Term (2).
    """
    return f_dielectric(_cosine(theta), eta)


def reflected_share_s(theta, eta):
    """The share reflected of light polarised across the plane of incidence, at an angle.

    f_dielectric_s(cos theta, eta)

    theta (...) rad, eta (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Fresnel 1823.
    """
    return f_dielectric_s(_cosine(theta), eta)


def reflected_share_p(theta, eta):
    """The share reflected of light polarised along the plane of incidence, at an angle.

    f_dielectric_p(cos theta, eta)

    theta (...) rad, eta (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Fresnel 1823.
    """
    return f_dielectric_p(_cosine(theta), eta)


def transmitted_share(theta, eta):
    """The share of unpolarised light that enters at an angle.

    t_dielectric(cos theta, eta)

    theta (...) rad, eta (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: deck, Fresnel Term (1).
    """
    return t_dielectric(_cosine(theta), eta)


def both_shares(theta, eta):
    """What is reflected and what enters, together: 1 at every angle.

    reflected_share + transmitted_share, two formulas

    theta (...) rad, eta (...) > 0. Returns (...) 1. Errors: rounding. Source: deck, Fresnel Term (1).
    """
    return reflected_share(theta, eta) + transmitted_share(theta, eta)


def polarised_share(theta, eta, polariser):
    """The share reflected of the light that a polariser before the eye lets through.

    s cos^2 polariser + p sin^2 polariser, s = reflected_share_s, p = reflected_share_p

    theta (...) rad, eta (...) > 0, polariser (...) rad, 0: lets s through. Returns (...) 0 .. 1. Errors: none.
    Source: Malus 1809; Fresnel 1823.
    """
    c, s = np.cos(np.asarray(polariser, float)), np.sin(np.asarray(polariser, float))
    return reflected_share_s(theta, eta) * c * c + reflected_share_p(theta, eta) * s * s


def refracted_angle(theta, eta):
    """The angle of the ray that enters, from the normal on the far side; 90 degrees where none does.

    atan2(sin theta, eta refracted_cosine)

    theta (...) rad 0 .. 90 degrees, beyond as at 90; eta (...) > 0. Returns (...) rad. Errors: none.
    Source: Snell's law.
    """
    theta = np.minimum(np.asarray(theta, float), 0.5 * np.pi)
    return np.arctan2(np.sin(theta), eta * refracted_cosine(_cosine(theta), eta))


def schlick_share(theta, eta):
    """The share reflected at an angle, by Schlick's fit.

    f_schlick(cos theta, f0), f0 = ((eta - 1) / (eta + 1))^2

    theta (...) rad, eta (...) > 0. Returns (...) 0 .. 1. Errors: a fit. Source: Schlick 1994; deck, Fresnel Term (8).
    """
    return f_schlick(_cosine(theta), f0_from_eta(eta))


def f_average_schlick_eta(eta):
    """The share of diffuse light that is reflected, by Schlick's fit, from the index.

    f0 + (1 - f0) / 21, f0 = ((eta - 1) / (eta + 1))^2

    eta (...) > 0. Returns (...) 0 .. 1. Errors: a fit. Source: Schlick 1994, integrated.
    """
    return f_average_schlick(f0_from_eta(eta))


def angle_of_half(eta):
    """The angle in degrees at which a transparent medium reflects half of the light.

    f_dielectric(cos theta, eta) = 1/2, by 30 halvings of the interval of the cosine from 0 to 1

    eta (...) above 1, below 5.8, where half is reflected head-on. Returns (...) degrees. Errors: rounding.
    Source: Fresnel 1823.
    """
    eta = np.asarray(eta, float)
    low, high = np.zeros_like(eta), np.ones_like(eta)
    for _ in range(30):
        middle = 0.5 * (low + high)
        more = f_dielectric(middle, eta) > 0.5
        low, high = np.where(more, middle, low), np.where(more, high, middle)
    c = 0.5 * (low + high)
    return np.degrees(np.arctan2(np.sqrt((1 - c) * (1 + c)), c))[()]
