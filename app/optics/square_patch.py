"""The square patch of the lesson: where it is, and its solid angle exactly, as a small patch and by counting.

Its centre is `distance` away from the eye at the origin in the direction (theta, phi). At tilt 0 it faces the eye; tilt
turns it about the horizontal axis through its centre. Only what the horizon cuts depends on theta, nothing on phi.
"""

import numpy as np

from app.optics.projected_solid_angle import _AT, _WEIGHT, projected_solid_angle_polygon
from app.optics.solid_angle_flat import solid_angle_rectangle_beside, solid_angle_rectangle_off_axis
from app.optics.spherical import (
    direction,
    direction_phi,
    direction_theta,
    fibonacci_direction,
    fibonacci_direction_naive,
)


def _column(x):
    return np.asarray(x, float)[..., None]


def patch_point(theta, phi, distance, tilt, width, s, t):
    """A point of the square: s along its horizontal side, t along the side that tilts away; the centre at 1/2, 1/2.

    distance e_r + width ((s - 1/2) e_phi + (t - 1/2) (cos tilt e_theta + sin tilt e_r))

    theta, phi, tilt (...) rad, distance, width (...) m, s, t (...) in [0, 1]. Returns (..., 3) m. Errors: none.
    Source: deck, Solid Angles.
    """
    outward, tilt, width = direction(theta, phi), _column(tilt), _column(width)
    along = np.cos(tilt) * direction_theta(theta, phi) + np.sin(tilt) * outward
    return _column(distance) * outward + width * ((_column(s) - 0.5) * direction_phi(phi) + (_column(t) - 0.5) * along)


def patch_normal(theta, phi, tilt):
    """The square's unit normal: towards the eye at tilt 0, along e_theta at tilt pi/2.

    sin tilt e_theta - cos tilt e_r

    theta, phi, tilt (...) rad. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    tilt = _column(tilt)
    return np.sin(tilt) * direction_theta(theta, phi) - np.cos(tilt) * direction(theta, phi)


def solid_angle_patch(distance, tilt, width):
    """The solid angle of the square, exactly.

    In the square's own plane, distance |cos tilt| away and slid by distance sin tilt: solid_angle_rectangle_off_axis
    where the eye is over the square, else twice solid_angle_rectangle_beside.

    distance, width (...) m, tilt (...) rad. Returns (...) sr. Errors: none. Source: deck, Solid Angles.
    """
    distance, tilt, width = np.broadcast_arrays(*(np.asarray(x, float) for x in (distance, tilt, width)))
    slide, height, h = np.abs(distance * np.sin(tilt)), np.abs(distance * np.cos(tilt)), 0.5 * width
    over = solid_angle_rectangle_off_axis(-h, h, slide - h, slide + h, height)
    beside = 2 * solid_angle_rectangle_beside(np.maximum(slide - h, 0), slide + h, width, h, height)
    return np.where(slide <= h, over, beside)[()]


def solid_angle_patch_small(distance, tilt, width):
    """The solid angle of the square if it were small: its area, foreshortened, over the distance squared.

    width^2 |cos tilt| / distance^2

    distance, width (...) m, tilt (...) rad. Returns (...) sr. Errors: of order (width / distance)^2; unbounded near.
    Source: deck, Solid Angles.
    """
    distance, tilt, width = (np.asarray(x, float) for x in (distance, tilt, width))
    return (width / distance) ** 2 * np.abs(np.cos(tilt))


def _counted(direction_of, theta, phi, distance, tilt, width, samples):
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta, phi, distance, tilt, width, samples)))
    counts = []
    for *patch, count in zip(*(g.ravel() for g in given), strict=True):
        rays = direction_of(np.arange(int(count)), int(count))
        counts.append(np.count_nonzero(meets_patch(rays, *patch)))
    return (4 * np.pi * np.reshape(counts, given[0].shape) / given[-1])[()]


def solid_angle_patch_counted(theta, phi, distance, tilt, width, samples):
    """The solid angle of the square by counting: the share of evenly spread directions that meet it, times 4 pi.

    4 pi hits / samples over fibonacci_direction(0 .. samples - 1)

    theta, phi, tilt (...) rad, distance, width (...) m, samples (...) >= 1. Returns (...) sr, a multiple of
    4 pi / samples. Errors: falls like samples^(-3/4). Source: deck, Solid Angles; Swinbank and Purser 2006.
    """
    return _counted(fibonacci_direction, theta, phi, distance, tilt, width, samples)


def solid_angle_patch_counted_naive(theta, phi, distance, tilt, width, samples):
    """The solid angle of the square by counting directions in equal steps of the polar angle, as if dw = dtheta dphi.

    4 pi hits / samples over fibonacci_direction_naive(0 .. samples - 1)

    The arguments of solid_angle_patch_counted. Returns (...) sr. Errors: 2 / (pi sin theta) times too much for a small
    square at theta, at any number of samples. Source: deck, Solid Angles, dw = sin theta dtheta dphi.
    """
    return _counted(fibonacci_direction_naive, theta, phi, distance, tilt, width, samples)


def meets_patch(towards, theta, phi, distance, tilt, width):
    """Whether the ray from the eye along `towards` meets the square: 1.0 or 0.0.

    way = r cos(tilt) / (towards . n'), n' the square's normal away from the eye; then both coordinates within width / 2

    towards (..., 3) unit vector, theta, phi, tilt (...) rad, distance, width (...) m. Returns (...).
    Errors: none; a ray in the square's own plane misses it. Source: deck, Solid Angles.
    """
    towards = np.asarray(towards, float)
    along, fall, aside = (np.sum(towards * v, -1)
                          for v in (direction(theta, phi), direction_theta(theta, phi), direction_phi(phi)))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        way = distance * np.cos(tilt) / (along * np.cos(tilt) - fall * np.sin(tilt))
        x, y = way * aside, way * (fall * np.cos(tilt) + along * np.sin(tilt)) - distance * np.sin(tilt)
        return ((way > 0) & (np.maximum(np.abs(x), np.abs(y)) <= 0.5 * width)).astype(float)


def solid_angle_patch_ratio(distance, tilt, width):
    """What is left of the square's solid angle when it is pushed twice as far away.

    solid_angle_patch(2 distance) / solid_angle_patch(distance); 1/4 for a small square

    distance, width (...) m, tilt (...) rad. Returns (...). Errors: none. Source: deck, Solid Angles.
    """
    return solid_angle_patch(2 * np.asarray(distance, float), tilt, width) / solid_angle_patch(distance, tilt, width)


def projected_solid_angle_patch(theta, distance, tilt, width):
    """The projected solid angle of the square above the horizon, exactly: its shadow on the base disk.

    projected_solid_angle_polygon of the four corners; a small square above the horizon, where that rounds, by 8 x 8
    Gauss points of width^2 distance |cos tilt| z / r^4

    theta, tilt (...) rad, distance, width (...) m. Returns (...) sr. Errors: those of projected_solid_angle_polygon;
    in float32 more where the square's plane passes the eye closer than width / 1000. Source: Lambert 1760, Photometria.
    """
    theta, distance, tilt, width = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta, distance, tilt, width)))
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    corners = np.stack([patch_point(theta, 0, distance, tilt, width, s, t) for s, t in around], -2)
    small = (np.min(corners[..., 2], -1) > 0) & (width < 0.25 * distance)
    value = np.asarray(projected_solid_angle_polygon(corners, 4))
    value[small] = _quadrature(theta[small], distance[small], tilt[small], width[small])
    return value[()]


def _quadrature(theta, distance, tilt, width):
    total = np.zeros(theta.shape)
    for s, weight_s in zip(_AT, _WEIGHT, strict=True):
        for t, weight_t in zip(_AT, _WEIGHT, strict=True):
            p = patch_point(theta, 0, distance, tilt, width, s, t)
            total += weight_s * weight_t * p[..., 2] / np.sum(p * p, -1) ** 2
    return total * width**2 * distance * np.abs(np.cos(tilt))


def projected_solid_angle_patch_small(theta, distance, tilt, width):
    """The projected solid angle of the square if it were small.

    width^2 |cos tilt| / distance^2 max(0, cos theta)

    theta, tilt (...) rad, distance, width (...) m. Returns (...) sr. Errors: of order (width / distance)^2, more where
    the horizon cuts. Source: deck, Basic Concepts.
    """
    return solid_angle_patch_small(distance, tilt, width) * np.maximum(0, np.cos(np.asarray(theta, float)))
