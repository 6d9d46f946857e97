"""The deck's two tables of materials, as printed, and measured indices from which they are computed anew.

The numbers stand here and, by the same names, in materials.glsl; a test holds every one of them equal, and recomputes
the weights from CIE's tables.
"""

import numpy as np

from app.optics.colour import linear_to_srgb
from app.optics.fresnel import f_conductor, f_dielectric, f_f82, f_schlick

# The rows of the deck's tables, Fresnel Term (7) and (6), in their order: its F(0) linear and sRGB, as printed
_F0 = np.array([
    (0.02, 0.02, 0.02),  # water
    (0.03, 0.03, 0.03),  # plastic or glass (low)
    (0.05, 0.05, 0.05),  # plastic (high)
    (0.08, 0.08, 0.08),  # glass (high) or ruby
    (0.17, 0.17, 0.17),  # diamond
    (1.00, 0.71, 0.29),  # gold
    (0.95, 0.93, 0.88),  # silver
    (0.95, 0.64, 0.54),  # copper
    (0.56, 0.57, 0.58),  # iron
    (0.91, 0.92, 0.92),  # aluminium
])
_SRGB = np.array([
    (0.15, 0.15, 0.15),
    (0.21, 0.21, 0.21),
    (0.24, 0.24, 0.24),
    (0.31, 0.31, 0.31),
    (0.45, 0.45, 0.45),
    (1.00, 0.86, 0.57),
    (0.98, 0.97, 0.95),
    (0.98, 0.82, 0.76),
    (0.77, 0.78, 0.78),
    (0.96, 0.96, 0.97),
])
# Measured indices at 589 nm of a material for each of the first five rows
_ETA = np.array([
    1.333,  # water, 20 °C
    1.4585,  # fused silica, Malitson 1965
    1.592,  # polystyrene, Sultanova 2009
    1.768,  # sapphire and ruby, ordinary ray, Malitson & Dodge 1972
    2.4175,  # diamond, Phillip & Taft 1964
])
# Complex indices at the photon energies of Johnson & Christy 1972 (gold, silver, copper) and 1974 (iron); aluminium,
# Rakic 1995, interpolated linearly at these wavelengths
_WAVELENGTH = np.array([397.4, 413.3, 430.5, 450.9, 471.4, 495.9, 520.9, 548.6, 582.1, 616.8, 659.5, 704.5])  # nm
_INDEX = np.array([
    [(1.47, 1.952), (1.46, 1.958), (1.45, 1.948), (1.38, 1.914), (1.31, 1.849), (1.04, 1.833),
     (0.62, 2.081), (0.43, 2.455), (0.29, 2.863), (0.21, 3.272), (0.14, 3.697), (0.13, 4.103)],  # gold
    [(0.05, 2.07), (0.05, 2.275), (0.04, 2.462), (0.04, 2.657), (0.05, 2.869), (0.05, 3.093),
     (0.05, 3.324), (0.06, 3.586), (0.05, 3.858), (0.06, 4.152), (0.05, 4.483), (0.04, 4.838)],  # silver
    [(1.32, 2.116), (1.28, 2.207), (1.25, 2.305), (1.24, 2.397), (1.25, 2.483), (1.22, 2.564),
     (1.18, 2.608), (1.02, 2.577), (0.7, 2.704), (0.3, 3.205), (0.22, 3.747), (0.21, 4.205)],  # copper
    [(2.24, 2.58), (2.35, 2.65), (2.48, 2.71), (2.59, 2.77), (2.67, 2.82), (2.74, 2.88),
     (2.86, 2.91), (2.95, 2.93), (2.94, 2.99), (2.88, 3.05), (2.92, 3.1), (2.86, 3.19)],  # iron
    [(0.4813, 4.8032), (0.5214, 5.001), (0.5718, 5.2148), (0.6364, 5.4652), (0.7085, 5.7122), (0.7975, 6.0002),
     (0.8917, 6.2914), (1.0092, 6.6111), (1.1692, 6.9882), (1.3497, 7.3707), (1.6235, 7.7998),
     (1.9581, 8.1749)],  # aluminium
])
# What each of these wavelengths adds to linear sRGB: D65 times the 1931 observer, F linear in between; sums are 1
_WEIGHT = np.array([
    (0.00166, -0.00144, 0.01017),
    (0.00891, -0.00792, 0.05689),
    (0.03306, -0.03154, 0.24956),
    (0.02592, -0.03533, 0.40547),
    (-0.04730, 0.02233, 0.29555),
    (-0.14016, 0.13672, 0.08943),
    (-0.21814, 0.33231, -0.01127),
    (-0.00878, 0.40730, -0.04681),
    (0.49273, 0.20513, -0.03522),
    (0.63322, -0.00762, -0.01183),
    (0.20338, -0.01826, -0.00184),
    (0.01550, -0.00168, -0.00010),
])
INSULATORS = 5  # the first rows; metals follow


def material_f0(material):
    """The share reflected at normal incidence of a row of the deck's tables, linear, as printed.

    0 water, 1 plastic or glass (low), 2 plastic (high), 3 glass (high) or ruby, 4 diamond, 5 gold, 6 silver, 7 copper,
    8 iron, 9 aluminium

    material (...) 0 .. 9, integers. Returns (..., 3). Errors: printed with two decimals; see f_material.
    Source: deck, Fresnel Term (6), (7), from Physically Based Shading, SIGGRAPH course 2010.
    """
    return _F0[np.asarray(material)]


def material_srgb(material):
    """The same share as the deck prints it for the screen, in sRGB.

    rows as in material_f0

    material (...) 0 .. 9, integers. Returns (..., 3). Errors: four entries are not the sRGB of the linear column: both
    were rounded from a hidden value. Source: deck, Fresnel Term (6), (7).
    """
    return _SRGB[np.asarray(material)]


def material_eta(material):
    """The measured index of a transparent material for a row of the deck's table, at 589 nm; 1 for metals.

    water 1.333, fused silica 1.4585, polystyrene 1.592, ruby 1.768, diamond 2.4175

    material (...) 0 .. 9, integers. Returns (...). Errors: three decimals. Source: Malitson 1965; Sultanova 2009;
    Malitson & Dodge 1972; Phillip & Taft 1964.
    """
    material = np.asarray(material)
    return np.where(material < INSULATORS, _ETA[np.minimum(material, INSULATORS - 1)], 1.0)[()]


def metal_index(material, wavelength_index):
    """The measured complex index (eta, k) of a metal at one of twelve wavelengths from 397 to 705 nm.

    rows as in material_f0; of what is no metal, gold's

    material (...) 0 .. 9, wavelength_index (...) 0 .. 11, integers. Returns (..., 2). Errors: two decimals; thin films.
    Source: Johnson & Christy 1972, 1974; Rakic 1995.
    """
    return _INDEX[np.maximum(np.asarray(material) - INSULATORS, 0), np.asarray(wavelength_index)]


def wavelength_weight(wavelength_index):
    """What one of the twelve wavelengths adds to linear sRGB, in daylight.

    int D65 (M xyz-bar) hat dlambda, hat the linear interpolation's, each channel's sum 1

    wavelength_index (...) 0 .. 11, integers. Returns (..., 3), partly below 0. Errors: five decimals.
    Source: CIE 015:2004, 10 nm tables; IEC 61966-2-1 for M.
    """
    return _WEIGHT[np.asarray(wavelength_index)]


def f_material(l_dot_h, material):
    """The Fresnel term of a row of the deck's tables in linear sRGB, exact from measured indices.

    transparent: f_dielectric(l_dot_h, material_eta); metals: sum_i wavelength_weight_i f_conductor(l_dot_h, eta_i, k_i)

    l_dot_h (...) 0 .. 1, material (...) 0 .. 9, integers. Returns (..., 3); gold's red is 1.03: out of gamut.
    Errors: twelve wavelengths, .003 from 10 nm steps. Source: deck, Fresnel Term (6), (7); sources of metal_index.
    """
    c, material = np.broadcast_arrays(np.asarray(l_dot_h, float), np.asarray(material))
    clear = f_dielectric(c, np.where(material < INSULATORS, material_eta(material), 1.5))
    index = _INDEX[np.maximum(material - INSULATORS, 0)]
    metal = f_conductor(c[..., None], index[..., 0], index[..., 1]) @ _WEIGHT
    return np.where((material < INSULATORS)[..., None], np.asarray(clear)[..., None], metal)


def _channel(value, channel):
    return np.take_along_axis(value, np.broadcast_to(np.asarray(channel), value.shape[:-1])[..., None], -1)[..., 0]


def _at(theta, material, channel):
    theta, material, channel = np.broadcast_arrays(np.asarray(theta, float), material, channel)
    return np.maximum(0.0, np.cos(theta)), material, channel


def material_share(theta, material, channel):
    """The share of light a row of the tables reflects at an angle, in one channel: 0 red, 1 green, 2 blue.

    f_material(cos theta, material)

    theta (...) rad, material, channel (...) integers. Returns (...). Errors: those of f_material.
    Source: deck, Fresnel Term (4), (5).
    """
    c, material, channel = _at(theta, material, channel)
    return _channel(f_material(c, material), channel)[()]


def material_share_schlick(theta, material, channel):
    """The same by Schlick's fit, from the exact share at normal incidence.

    f_schlick(cos theta, f_material(1, material))

    theta (...) rad, material, channel (...) integers. Returns (...). Errors: a fit. Source: Schlick 1994.
    """
    c, material, channel = _at(theta, material, channel)
    return f_schlick(c, _channel(f_material(1.0, material), channel))[()]


def material_share_f82(theta, material, channel):
    """The same by the fit that also passes through the exact share at l_dot_h = 1/7.

    f_f82(cos theta, f_material(1, material), f_material(1/7, material))

    theta (...) rad, material, channel (...) integers. Returns (...). Errors: a fit. Source: Hoffman 2019.
    """
    c, material, channel = _at(theta, material, channel)
    f0, f82 = (_channel(f_material(x, material), channel) for x in (1.0, 1 / 7))
    return f_f82(c, f0, f82)[()]


def material_f0_printed(material, channel):
    """One channel of material_f0.

    material_f0(material)[channel]

    material, channel (...) integers. Returns (...). Errors: none. Source: deck, Fresnel Term (6), (7).
    """
    material, channel = np.broadcast_arrays(material, channel)
    return _channel(material_f0(material), channel)[()]


def material_srgb_printed(material, channel):
    """One channel of material_srgb.

    material_srgb(material)[channel]

    material, channel (...) integers. Returns (...). Errors: none. Source: deck, Fresnel Term (6), (7).
    """
    material, channel = np.broadcast_arrays(material, channel)
    return _channel(material_srgb(material), channel)[()]


def material_srgb_of_printed(material, channel):
    """One channel of the sRGB value that belongs to the printed linear one.

    linear_to_srgb(material_f0_printed)

    material, channel (...) integers. Returns (...) 0 .. 1. Errors: none. Source: IEC 61966-2-1.
    """
    return linear_to_srgb(material_f0_printed(material, channel))


def schlick_worst(material):
    """The largest distance of Schlick's fit from the exact share, over 91 angles and three channels.

    max |material_share_schlick - material_share|, theta = 0, 1, .. 90 degrees

    material () 0 .. 9, integers. Returns () 0 .. 1. Errors: between whole degrees it is larger by up to 1e-4.
    Source: Schlick 1994, measured here.
    """
    material, theta = np.asarray(material)[..., None, None], np.radians(np.arange(91.0))[:, None]
    off = material_share_schlick(theta, material, np.arange(3)) - material_share(theta, material, np.arange(3))
    return np.max(np.abs(off), axis=(-2, -1))[()]
