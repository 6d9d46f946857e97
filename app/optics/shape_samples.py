"""Estimates of the irradiance from an area light by samples on it, each a punctual light with a share of it.

Every shape answers the same question (light_piece): where does a sample lie, and for how much solid angle does it
stand? The irradiance is then the radiance times the mean of weight and n.l, whatever the shape and the kind of sample.
"""

import numpy as np

from app.optics.area_light import panel_point, panel_view
from app.optics.light_samples import concentric_disk, light_sample
from app.optics.light_shape import DISK, POLYGON, SPHERE, light_area
from app.optics.solid_angle_flat import solid_angle_rectangle_off_axis
from app.optics.spherical_rectangle import spherical_rectangle_point

_RIM = np.array([[0.5, 0.4], [0.3, 1.0], [-0.3, 1.0], [-0.5, 0.4]])  # of the pentagon, from its first corner
_PARTS = np.array([0.0, 0.19, 0.49, 0.68])  # of its panel: the triangles from the first corner, summed


def even_in_angle(panel_width, panel_depth, seen):
    """Whether samples even in solid angle are worth it: 1.0, or 0.0 for a panel far away or thin, and behind it.

    min(w, d) > 0.03 |seen|: smaller ones look the same from everywhere, and their edges round in float32

    panel_width, panel_depth (...) m, seen (..., 3) m as panel_view. Returns (...). Errors: none.
    Source: Pharr et al. 2023, pbrt-v4, which samples small rectangles by area too.
    """
    seen = np.asarray(seen, float)
    large = np.minimum(panel_width, panel_depth) > 0.03 * np.sqrt(np.sum(seen * seen, -1))
    return ((seen[..., 2] > 0) & large).astype(float)


def fan_point(s, t):
    """A point of the pentagon in the unit square about 0, even in area: a fan of triangles from its first corner.

    (0, -1/2) + sqrt(s) rim(t), the rim run through from the second corner to the last so that the areas of the
    triangles passed are in proportion to t

    s, t (...) in [0, 1]. Returns (..., 2). Errors: none. Source: Turk 1990, Generating Random Points in Triangles.
    """
    s, t = np.broadcast_arrays(np.asarray(s, float), np.asarray(t, float))
    rim = np.stack([np.interp(0.68 * t, _PARTS, _RIM[:, k]) for k in (0, 1)], -1)
    return np.array([0.0, -0.5]) + np.sqrt(s)[..., None] * rim


def shape_point(light_shape, s, t):
    """A point of a flat shape in the unit square about 0, even in area.

    panel (s, t) - 1/2; disk concentric_disk / 2; pentagon fan_point

    light_shape (...) int, s, t (...) in [0, 1]. Returns (..., 2). Errors: none.
    Source: deck, Light Contribution of Area Lights (1).
    """
    shape, s, t = np.broadcast_arrays(light_shape, np.asarray(s, float), np.asarray(t, float))
    whole, disk = np.stack([s, t], -1) - 0.5, 0.5 * concentric_disk(s, t)
    return np.where((shape == DISK)[..., None], disk, np.where((shape == POLYGON)[..., None], fan_point(s, t), whole))


def shape_holds(light_shape, s, t):
    """Whether a point of the unit square belongs to the shape: a sample beside it counts nothing.

    disk: within 1/2 of the middle; pentagon, x = |s - 1/2|: t >= 0.8 x and 3 x + t <= 1.9; else all

    light_shape (...) int, s, t (...) in [0, 1]. Returns (...), 1.0 or 0.0. Errors: a step.
    Source: Gamito 2016, Solid Angle Sampling of Disk and Cylinder Lights (rejection in the square around).
    """
    shape, s, t = np.broadcast_arrays(light_shape, np.asarray(s, float), np.asarray(t, float))
    x, y = np.abs(s - 0.5), t - 0.5
    disk, pentagon = x * x + y * y <= 0.25, (t >= 0.8 * x) & (3 * x + t <= 1.9)
    return np.where(shape == DISK, disk, np.where(shape == POLYGON, pentagon, True)).astype(float)[()]


def sampled_area(light_shape, light_x, light_y, light_height, panel_width, panel_depth, position):
    """The area that the samples share: all of the light, but of a sphere only the cap that the point sees.

    light_area; sphere outside: 2 pi r^2 (1 - r / d), d from the point to its middle

    light_shape (...) int, light_x, light_y, light_height, panel_width, panel_depth (...) m, position (..., 3) m.
    Returns (...) m^2. Errors: none. Source: deck, Light Contribution of Area Lights (1); Archimedes' cap.
    """
    middle = np.stack(np.broadcast_arrays(*(np.asarray(v, float) for v in (light_x, light_y, light_height))), -1)
    d, radius = np.sqrt(np.sum((middle - np.asarray(position, float)) ** 2, -1)), 0.5 * np.asarray(panel_width, float)
    outside = (np.asarray(light_shape) == SPHERE) & (d > radius)
    cap = 2 * np.pi * radius**2 * (d - radius) / np.where(d > 0, d, 1.0)
    return np.where(outside, cap, light_area(light_shape, panel_width, panel_depth))[()]


def sample_flux(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, position, level):
    """The flux of each of the punctual lights that stand for the area light.

    pi L A / N, A = sampled_area, N = 4^level; the intensity of each is L A cos_light / N

    light_shape (...) int, radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m,
    position (..., 3) m, level (...) int. Returns (...) W; they sum to the flux of all that is seen. Errors: none.
    Source: deck, Light Contribution of Area Lights (1): "derived from the area light".
    """
    area = sampled_area(light_shape, light_x, light_y, light_height, panel_width, panel_depth, position)
    return np.pi * np.asarray(radiance, float) * area / 4.0 ** np.asarray(level)


def sample_share(to_sample):
    """What a sample gives per area, radiance and distance of its plane: the rest of cos cos_light / r^2.

    max(0, to_sample.z) / r^4, r = |to_sample|; cos = to_sample.z / r and cos_light = distance of the plane / r

    to_sample (..., 3) m, from the shaded point, its normal +z. Returns (...) 1/m^3. Errors: none.
    Source: deck, Light Contribution of Area Lights (1), with the emitter's cosine.
    """
    to_sample = np.asarray(to_sample, float)
    r2 = np.sum(to_sample * to_sample, -1)
    up = to_sample[..., 2] > 0
    return (np.where(up, to_sample[..., 2], 0) / np.where(up, r2, 1) / np.where(up, r2, 1))[()]


def sphere_piece(to_light, radius, sampling, s, t):
    """The way to a sample of a sphere, and the solid angle it stands for.

    kinds 0 to 3, even in area over the cap the point sees, A = 2 pi r^2 (1 - r/d): A cos_light / r^2; kinds 4 and 5,
    even in solid angle over the cone: 2 pi (1 - sqrt(1 - (r/d)^2)); from inside 4 pi, in every direction

    to_light (..., 3) m to the middle, radius (...) m, sampling (...) int, s, t (...) in [0, 1]. Returns (..., 4): way
    in m, weight in sr. Errors: none. Source: Shirley, Wang, Zimmerman 1996, Monte Carlo Techniques for Direct Lighting
    Calculations.
    """
    to_light, radius, kind = np.asarray(to_light, float), np.asarray(radius, float), np.asarray(sampling)
    s, t = np.asarray(s, float), np.asarray(t, float)
    shape = np.broadcast_shapes(to_light.shape[:-1], radius.shape, kind.shape, s.shape, t.shape)
    to_light, radius = np.broadcast_to(to_light, (*shape, 3)), np.broadcast_to(radius, shape)
    d, lean = np.sqrt(np.sum(to_light**2, -1)), np.hypot(to_light[..., 0], to_light[..., 1])
    outside, safe = d > radius, np.where(d > 0, d, 1.0)
    w = np.where((d > 0)[..., None], to_light / safe[..., None], [0.0, 0.0, 1.0])
    flat = to_light[..., :2] / np.where(lean > 0, lean, 1.0)[..., None]
    leaning = np.concatenate([-w[..., 2:] * flat, (lean / safe)[..., None]], -1)
    aside = np.where((lean > 0)[..., None], leaning, [1.0, 0.0, 0.0])
    across = np.cross(w, aside)
    # the cap
    p = concentric_disk(s, t)
    h, r2 = np.where(outside, d - radius, 1.0), np.sum(p * p, -1)
    low = h / np.where(outside, d, 1.0) * r2  # 1 - cos of the angle at the sphere's middle
    away = h * h + 2 * radius * h * r2
    spread = radius * np.sqrt(h / np.where(outside, d, 1.0) * (2 - low))
    by_area = w * (h + radius * low)[..., None] + (aside * p[..., :1] + across * p[..., 1:]) * spread[..., None]
    rim = np.min(np.broadcast_arrays(s, 1 - s, t, 1 - t), 0)  # 1 - r2 = 4 rim (1 - rim)
    cosine = h * 4 * rim * (1 - rim) / np.sqrt(away)
    area = 2 * np.pi * radius**2 * h / np.where(outside, d, 1.0)
    # the cone
    q = np.where(outside, radius / safe, 1.0)
    wide = np.where(outside, q * q / (1 + np.sqrt((1 - q) * (1 + q))), 2.0)  # 1 - cos of its half angle
    low = wide * s
    sine, turn = np.sqrt(np.maximum(low * (2 - low), 0)), 2 * np.pi * t
    half_chord = np.sqrt(np.maximum((radius - d * sine) * (radius + d * sine), 0))
    around = aside * np.cos(turn)[..., None] + across * np.sin(turn)[..., None]
    to = w * (1 - low)[..., None] + sine[..., None] * around
    far = d * (1 - low) + np.where(outside, -half_chord, half_chord)
    cap = (kind < 4) & outside
    return np.concatenate([np.where(cap[..., None], by_area, far[..., None] * to),
                           np.where(cap, area * cosine / away, 2 * np.pi * wide)[..., None]], -1)


def light_piece(light_shape, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position, sampling,
                level, seed, index):
    """The way from a point to a sample of the light, and the solid angle it stands for: a punctual light of this share.

    flat, by area (kinds 0 to 3, and where even_in_angle says no): A cos_light / r^2 at shape_point; even in solid angle
    (4 and 5): that of the whole square at spherical_rectangle_point, 0 beside the shape; sphere_piece

    light_shape (...) int, light_x, light_y, light_height, panel_width, panel_depth (...) m, panel_tilt (...) rad,
    position (..., 3) m, sampling, level, seed, index (...) int. Returns (..., 4): way in m, weight in sr; the mean of
    the weights tends to the light's solid angle, and is 0 behind a flat one. Errors: as spherical_rectangle_point.
    Source: deck, Light Contribution of Area Lights (1); Urena, Fajardo, King 2013; Gamito 2016.
    """
    given = [np.asarray(v, float) for v in (light_x, light_y, light_height, panel_width, panel_depth, panel_tilt)]
    whole = [np.asarray(v) for v in (light_shape, sampling, level, seed, index)]
    place = np.asarray(position, float)
    shape = np.broadcast_shapes(*(v.shape for v in (*given, *whole)), place.shape[:-1])
    given = [np.broadcast_to(v, shape).ravel() for v in given]
    kinds, sampling, level, seed, index = (np.broadcast_to(v, shape).ravel() for v in whole)
    place = np.broadcast_to(place, (*shape, 3)).reshape(-1, 3)
    at, value = light_sample(sampling, level, seed, index), np.zeros((kinds.size, 4))
    for kind in sorted(set(kinds.tolist())):
        here = np.flatnonzero(kinds == kind)
        value[here] = _pieces(kind, [v[here] for v in given], place[here], sampling[here], at[here])
    return value.reshape(*shape, 4)


def _pieces(light_shape, panel, position, sampling, at):
    """light_piece of one shape: panel six arrays (...), position (..., 3), at (..., 3) as light_sample."""
    x, y, height, width, depth, tilt = np.broadcast_arrays(*panel)
    s, t, times = np.moveaxis(at, -1, 0)
    if light_shape == SPHERE:
        piece = sphere_piece(np.stack([x, y, height], -1) - position, 0.5 * width, sampling, s, t)
        return piece * np.stack([np.ones_like(times)] * 3 + [times], -1)
    if light_shape == DISK:
        depth, tilt = width, np.zeros_like(tilt)
    seen = panel_view(x, y, height, tilt, position)
    area, front = light_area(light_shape, width, depth), seen[..., 2] > 0
    u, v = np.moveaxis(shape_point(light_shape, s, t), -1, 0)
    way = panel_point(x, y, height, width, depth, tilt, u + 0.5, v + 0.5) - position
    r2 = np.sum(way * way, -1)
    weight = area * np.maximum(seen[..., 2], 0) / (r2 * np.sqrt(r2))
    by_angle = (np.asarray(sampling) >= 4) & (even_in_angle(width, depth, seen) > 0)
    if by_angle.any():
        z = np.where(front, seen[..., 2], 1.0)
        sides = (*(seen[..., 0] + k * width for k in (-0.5, 0.5)), *(seen[..., 1] + k * depth for k in (-0.5, 0.5)), z)
        p = spherical_rectangle_point(*sides, s, t)
        hit = shape_holds(light_shape, (p[..., 0] - sides[0]) / np.where(by_angle, width, 1),
                          (p[..., 1] - sides[2]) / np.where(by_angle, depth, 1))
        cos, sin = np.cos(tilt), np.sin(tilt)
        turned = np.stack([p[..., 0], p[..., 1] * cos - p[..., 2] * sin, p[..., 1] * sin + p[..., 2] * cos], -1)
        way = np.where(by_angle[..., None], turned, way)
        weight = np.where(by_angle, hit * solid_angle_rectangle_off_axis(*sides), weight)
    return np.concatenate([way, (weight * times)[..., None]], -1)


def irradiance_light_sampled(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth,
                             panel_tilt, position, sampling, level, seed):
    """The irradiance on the floor from an area light, estimated by N = 4^level samples.

    L / N sum of weight max(0, n.l), weight and l of light_piece; 0 behind a flat light

    light_shape (...) int, radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m,
    panel_tilt (...) rad, position (..., 3) m, sampling, level, seed (...) int. Returns (...) W/m^2. Errors: random
    falls like N^(-1/2), stratified like N^(-1), Sobol about N^(-1), a grid of middles N^(-1), Gauss-Legendre faster
    than any power up to level 3 for a panel or sphere that the horizon does not cut.
    Sources: deck, Light Contribution of Area Lights (1); optics reference 5.
    """
    def share(piece, inside, area):
        return piece[..., 3] * np.maximum(piece[..., 2], 0) / np.sqrt(np.sum(piece[..., :3] ** 2, -1))

    return _summed(share, light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                   position, sampling, level, seed)


def irradiance_light_without_cosine(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth,
                                    panel_tilt, position, level):
    """The irradiance from a grid of samples that each shine alike in every direction: the emitter's cosine forgotten.

    L / N sum of A n.l / r^2, over the samples that are seen

    The arguments of irradiance_light_sampled, samples in the middles of 2^level x 2^level cells. Returns (...) W/m^2.
    Errors: too much, by 1 / cos_light of each sample. Source: deck, Light Contribution of Area Lights (1), misread.
    """
    def share(piece, inside, area):
        r2 = np.sum(piece[..., :3] ** 2, -1)
        weight = np.where(inside, piece[..., 3], np.where(piece[..., 3] > 0, area / r2, 0.0))
        return weight * np.maximum(piece[..., 2], 0) / np.sqrt(r2)

    return _summed(share, light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                   position, 0, level, 0)


def _summed(share, light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
            position, sampling, level, seed):
    """L times the mean of share(piece, inside, area) over the samples; shape by shape, in blocks of samples."""
    given = [np.asarray(v, float) for v in (light_x, light_y, light_height, panel_width, panel_depth, panel_tilt)]
    whole = [np.asarray(v) for v in (light_shape, sampling, level, seed)]
    place, radiance = np.asarray(position, float), np.asarray(radiance, float)
    shape = np.broadcast_shapes(*(v.shape for v in (*given, *whole, radiance)), place.shape[:-1])
    given = [np.broadcast_to(v, shape).ravel() for v in given]
    kinds, samplings, levels, seeds = (np.broadcast_to(v, shape).ravel() for v in whole)
    place = np.broadcast_to(place, (*shape, 3)).reshape(-1, 3)
    middle = np.stack(given[:3], -1) - place
    inside = (kinds == SPHERE) & (np.sqrt(np.sum(middle * middle, -1)) <= 0.5 * given[3])
    area, value = sampled_area(kinds, *given[:5], place), np.zeros(kinds.size)
    for kind, how, fine in sorted(set(zip(kinds.tolist(), samplings.tolist(), levels.tolist(), strict=True))):
        here = np.flatnonzero((kinds == kind) & (samplings == how) & (levels == fine))
        panel, total = [v[here, None] for v in given], np.zeros(here.size)
        for start in range(0, 4**fine, 4096):
            at = light_sample(how, fine, seeds[here, None], np.arange(start, min(4**fine, start + 4096)))
            piece = _pieces(kind, [np.broadcast_to(v, at.shape[:-1]) for v in panel], place[here, None], how, at)
            total += np.sum(share(piece, inside[here, None], area[here, None]), -1)
        value[here] = total / 4**fine
    return (np.broadcast_to(radiance, shape).ravel() * value).reshape(shape)[()]
