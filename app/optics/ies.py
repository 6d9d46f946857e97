"""Intensities of a measured luminaire from its table (app/ies): interpolated, summed to a flux, lighting a room.

A table holds angles in degrees and candela; its rows are told in app/ies/photometry.py. theta is counted from straight
down, phi from the luminaire's front counter-clockwise as seen from above: the angles of type C photometry.
"""

import numpy as np

from app.optics.spot import spot_flux

SLACK = 1e-4  # degrees: the measured range ends this much later, so that its last angle belongs to it in any arithmetic


def ies_place(table, row, angle):
    """Where an angle lies among the table's angles: the number of the one below it, and the weights of the two.

    i, (a_(i+1) - angle) / (a_(i+1) - a_i), (angle - a_i) / (a_(i+1) - a_i), each weight from its own difference, which
    is exact; i = -1 and no weight outside the measured range

    table (rows, columns); row: 1 the angles from the pole, 2 the azimuths; angle (...) degrees. Returns (..., 3).
    Errors: none. Source: optics reference 7.8; IES LM-63-2002.
    """
    table, row, angle = np.asarray(table, float), np.asarray(row), np.asarray(angle, float)
    if row.ndim:
        return np.where((row == 1)[..., None], ies_place(table, 1, angle), ies_place(table, 2, angle))
    known = table[int(row), :int(table[0, int(row)])]
    low = np.clip(np.searchsorted(known, angle, "right") - 1, 0, len(known) - 2)
    a, b = known[low], known[low + 1]
    inside = (angle >= known[0] - SLACK) & (angle <= known[-1] + SLACK)
    weights = (np.where(inside, np.clip(x / (b - a), 0, 1), 0.0) for x in (b - angle, angle - a))
    return np.stack([np.where(inside, low, -1.0), *weights], -1)


def ies_candela(table, theta, phi):
    """The luminous intensity in a direction, bilinear between the measured angles and 0 outside them.

    type B: the pole is horizontal; with down = cos theta, front = sin theta cos phi, side = sin theta sin phi:
    polar angle atan2(hypot(down, front), -side), azimuth atan2(front, down)

    table (rows, columns); theta (...) rad from straight down; phi (...) rad, -pi .. pi. Returns (...) cd.
    Errors: exact for the interpolant. Source: optics reference 7.8; IES LM-63-2002.
    """
    table = np.asarray(table, float)
    theta, phi = np.broadcast_arrays(np.asarray(theta, float), np.asarray(phi, float))
    if table[0, 0] > 0.5:
        down, front, side = np.cos(theta), np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi)
        theta, phi = np.arctan2(np.hypot(down, front), -side), np.arctan2(front, down)
    p, q = ies_place(table, 1, np.degrees(theta)), ies_place(table, 2, np.degrees(phi))
    i, j = (np.maximum(place[..., 0], 0).astype(int) for place in (p, q))
    lower = table[j + 3, i] * p[..., 1] + table[j + 3, i + 1] * p[..., 2]
    upper = table[j + 4, i] * p[..., 1] + table[j + 4, i + 1] * p[..., 2]
    return (lower * q[..., 1] + upper * q[..., 2])[()]


def ies_ring_flux(theta, d_theta, candela_below, candela_above):
    """The luminous flux in the ring around theta, between whose edges the intensity runs linearly in the angle.

    2 pi int I sin t dt = 2 pi ((I_0 + I_1) sin theta sin h + (I_1 - I_0) cos theta h j_1(h)), h = d_theta / 2, j_1 the
    spherical Bessel function; the same as 2 pi (-(p + q t) cos t + q sin t) between the edges, without its cancellation

    theta (...) rad, the ring's middle; d_theta (...) rad, its width; candela_below, candela_above (...) cd at
    theta -+ h. Returns (...) lm. Errors: none. Source: optics reference 7.8; deck, Units for Lighting - Candela.
    """
    theta, h = np.asarray(theta, float), 0.5 * np.asarray(d_theta, float)
    below, above = np.asarray(candela_below, float), np.asarray(candela_above, float)
    even, odd = np.sin(theta) * np.sin(h), np.cos(theta) * _h_j1(h)
    return 2 * np.pi * ((below + above) * even + (above - below) * odd)


def ies_flux(table):
    """The luminous flux of the interpolated intensities, each piece between two angles integrated exactly.

    sum over the rings of ies_ring_flux(middle, width, I_i, I_(i+1)), I_i the mean over the azimuths by trapezoids,
    which is exact for what is linear between the planes

    table (rows, columns). Returns () lm. Errors: none for the interpolant; a smooth source is missed by O(h^2): 1000
    cos theta cd at 5 degrees gives 3139.60 lm, and 1000 pi = 3141.59 lm is the source's own.
    Source: optics reference 7.8.
    """
    table = np.asarray(table, float)
    n, planes = int(table[0, 1]), int(table[0, 2])
    t, phi = np.radians(table[1, :n]), np.radians(table[2, :planes])
    rows = table[3:3 + planes, :n]
    mean = np.sum(np.diff(phi)[:, None] * (rows[:-1] + rows[1:]), 0) / (4 * np.pi)
    return np.sum(ies_ring_flux(0.5 * (t[1:] + t[:-1]), np.diff(t), mean[:-1], mean[1:]))


def _h_j1(h):
    """h j_1(h) = sin h / h - cos h; its series where that cancels."""
    x, series = h * h, 1.0
    for k in (130, 88, 54, 28, 10):
        series = 1 - x / k * series
    return np.where(h < 0.3, x / 3 * series, np.sin(h) / np.where(h < 0.3, 1, h) - np.cos(h))


def ies_declared(table):
    """The flux the file's lamps are declared to emit, lamps times lumens per lamp.

    the fourth number of the table's header

    table (rows, columns). Returns () lm; NaN where the photometry is absolute and declares none. Errors: as printed in
    the file. Source: IES LM-63-2002.
    """
    return np.asarray(table, float)[0, 3]


def ies_peak(table):
    """The largest intensity of the table.

    the fifth number of the table's header

    table (rows, columns). Returns () cd. Errors: none. Source: IES LM-63-2002.
    """
    return np.asarray(table, float)[0, 4]


def ies_lumens(table):
    """The flux of the interpolated intensities, as the table keeps it: ies_flux, summed once when the table is made.

    the sixth number of the table's header

    table (rows, columns). Returns () lm. Errors: those of ies_flux. Source: optics reference 7.8.
    """
    return np.asarray(table, float)[0, 5]


def ies_solid(table, s, t):
    """The photometric solid over the unit square: in each direction as far out as the intensity, the peak being 1.

    I / I_peak (sin theta cos phi, sin theta sin phi, -cos theta), theta = pi t, phi = 2 pi s, from the front

    table (rows, columns); s, t (...), 0 .. 1. Returns (..., 3), +z up. Errors: none. Source: deck, IES Lights.
    """
    s, t = np.broadcast_arrays(np.asarray(s, float), np.asarray(t, float))
    theta, phi = np.pi * t, _turned(s)
    way = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), -np.cos(theta)], -1)
    return way * (ies_candela(table, theta, phi) / ies_peak(table))[..., None]


def ies_solid_candela(table, s, t):
    """The luminous intensity at a point of the photometric solid.

    ies_candela(pi t, 2 pi s)

    table (rows, columns); s, t (...), 0 .. 1. Returns (...) cd. Errors: none. Source: deck, IES Lights.
    """
    return ies_candela(table, np.pi * np.asarray(t, float), _turned(s))


def _turned(s):
    """2 pi s in -pi .. pi."""
    s = np.asarray(s, float)
    return 2 * np.pi * np.where(s > 0.5, s - 1, s)


def ies_plane(table, theta, plane):
    """The luminous intensity along one photometric plane and on over the nadir into its opposite half.

    theta >= 0: ies_candela(theta, plane); theta < 0: ies_candela(-theta, plane -+ pi)

    table (rows, columns); theta (...) rad, -pi .. pi; plane (...) rad, 0 .. pi. Returns (...) cd. Errors: none.
    Source: deck, IES Lights.
    """
    theta, plane = np.asarray(theta, float), np.asarray(plane, float)
    return ies_candela(table, np.abs(theta), np.where(theta < 0, plane - np.pi, plane))


def ies_as_spot(table, off_axis, hotspot, falloff):
    """A measured luminaire in the place of a spotlight of the same flux, as a share of the spot's intensity.

    (I_ies(off_axis) / Phi_ies) (Phi_spot / I_spot), I_ies in the plane of the luminaire's front

    table (rows, columns); off_axis (...) rad, 0 .. pi; hotspot, falloff (...) rad, the spot's half angles.
    Returns (...), 0 or more, above 1 where the measured beam is stronger than the hotspot. Errors: exact for the
    interpolant. Source: deck, IES Lights and Light Sources - Spotlights (2), both integrated.
    """
    return ies_candela(table, off_axis, 0.0) * (spot_flux(1.0, hotspot, falloff) / ies_lumens(table))


def ies_towards(table, way, turn, aim):
    """The luminous intensity of a turned and aimed luminaire towards a point.

    way turned back by `turn` around the vertical, then by `aim` around the luminaire's side axis; its theta and phi

    table (rows, columns); way (..., 3) m from the luminaire, +z up; turn (...) rad, counter-clockwise; aim (...) rad
    from straight down towards the front. Returns (...) cd. Errors: none. Source: deck, IES Lights; IES LM-63-2002.
    """
    return ies_candela(table, *_aimed(way, turn, aim))


def _aimed(way, turn, aim):
    """theta and phi of a way, for a luminaire turned and aimed."""
    x, y, z = np.moveaxis(np.asarray(way, float), -1, 0)
    turn, aim = np.asarray(turn, float), np.asarray(aim, float)
    front, side = x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)
    front, up = front * np.cos(aim) + z * np.sin(aim), z * np.cos(aim) - front * np.sin(aim)
    return np.arctan2(np.hypot(front, side), -up), np.arctan2(side, front)


def ies_illuminance(table, way, normal, turn, aim):
    """The illuminance a luminaire gives to a surface, by the inverse square and the cosine.

    I max(0, -n . way) / |way|^3

    table (rows, columns); way (..., 3) m from the luminaire to the point; normal (..., 3), unit; turn, aim (...) rad.
    Returns (...) lx. Errors: far field, at least five times the luminaire's size away.
    Source: deck, Units for Lighting - Candela.
    """
    return ies_towards(table, way, turn, aim) * _falloff(way, normal)


def _falloff(way, normal):
    way, normal = np.asarray(way, float), np.asarray(normal, float)
    r, facing = np.sqrt(np.sum(way * way, -1)), -np.sum(way * normal, -1)
    lit = facing > 0
    return np.where(lit, facing / np.where(lit, r, 1) ** 3, 0.0)[()]


def ies_room_illuminance(table, height, setback, turn, aim, meter_x, meter_s):
    """The illuminance at a lux meter on the floor or the wall of a room, whose luminaire faces the wall at turn 0.

    meter_s <= 0: floor, -meter_s from the wall, normal up; meter_s > 0: wall, meter_s up it, normal to the room

    table (rows, columns); height, setback (...) m of the luminaire over the floor and from the wall; turn, aim (...)
    rad; meter_x, meter_s (...) m. Returns (...) lx. Errors: direct light only, far field. Source: deck, IES Lights.
    """
    return ies_illuminance(table, *_meter(height, setback, meter_x, meter_s), turn, aim)


def _meter(height, setback, meter_x, meter_s):
    """The way from the luminaire to the meter, in the frame whose x faces the wall, and the meter's normal."""
    height, setback, x, s = (np.asarray(v, float) for v in (height, setback, meter_x, meter_s))
    front, up = np.minimum(s, 0) + setback, np.maximum(s, 0) - height
    on_wall = s > 0
    way = np.stack(np.broadcast_arrays(front, -x, up), -1)
    return way, np.stack(np.broadcast_arrays(np.where(on_wall, -1.0, 0.0), 0.0, np.where(on_wall, 0.0, 1.0)), -1)
