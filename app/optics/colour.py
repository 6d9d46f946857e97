"""The sRGB transfer function, between linear light and what is stored and sent to a screen."""

import numpy as np


def linear_to_srgb(linear):
    """What is stored of a linear channel.

    12.92 x up to 0.0031308, beyond it 1.055 x^(1/2.4) - 0.055

    linear (...) 0 .. 1. Returns (...) 0 .. 1. Errors: none; at the joint the two pieces differ by 3e-8.
    Source: IEC 61966-2-1.
    """
    linear = np.asarray(linear, float)
    curve = 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, 12.92 * linear, curve)[()]


def srgb_to_linear(encoded):
    """The linear channel of what is stored.

    x / 12.92 up to 0.04045, beyond it ((x + 0.055) / 1.055)^2.4

    encoded (...) 0 .. 1. Returns (...) 0 .. 1. Errors: none; at the joint the two pieces differ by 1e-8.
    Source: IEC 61966-2-1.
    """
    encoded = np.asarray(encoded, float)
    return np.where(encoded <= 0.04045, encoded / 12.92, ((np.maximum(encoded, 0) + 0.055) / 1.055) ** 2.4)[()]
