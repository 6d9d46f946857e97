"""Estimates of the irradiance from the panel by samples on it, each a punctual light with a share of it."""

import numpy as np

from app.optics.area_light import _floats, panel_point, panel_view
from app.optics.light_samples import gauss_sample, grid_sample, random_sample, sobol_sample, stratified_sample
from app.optics.solid_angle_flat import solid_angle_rectangle_off_axis
from app.optics.spherical_rectangle import spherical_rectangle_point


def light_sample(sampling, level, seed, index):
    """A sample on the unit square and its weight, of one of six kinds.

    0 grid_sample, 1 random_sample, 2 stratified_sample, 3 and 4 sobol_sample, all of weight 1; 5 gauss_sample

    sampling, level, seed, index (...) int, index < 4^level. Returns (..., 3): s, t, weight; the weights of a level sum
    to 4^level. Errors: none. Source: deck, Light Contribution of Area Lights (1).
    """
    sampling, level, seed, index = np.broadcast_arrays(sampling, level, seed, index)
    kinds = [grid_sample(index, level), random_sample(index, seed), stratified_sample(index, level, seed),
             sobol_sample(index, seed)]
    at = np.choose(np.minimum(sampling, 3)[..., None], kinds)
    plain = np.concatenate([at, np.ones((*at.shape[:-1], 1))], -1)
    scale = np.stack([np.ones(level.shape), np.ones(level.shape), 4.0**level], -1)
    return np.where((sampling == 5)[..., None], gauss_sample(index, level) * scale, plain)


def _rectangle(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position):
    """The panel in its own axes as seen from a point: x0, x1, y0, y1, distance."""
    seen = panel_view(light_x, light_y, light_height, panel_tilt, position)
    w, d = 0.5 * np.asarray(panel_width, float), 0.5 * np.asarray(panel_depth, float)
    return seen[..., 0] - w, seen[..., 0] + w, seen[..., 1] - d, seen[..., 1] + d, seen[..., 2]


def even_in_angle(panel_width, panel_depth, seen):
    """Whether samples even in solid angle are worth it: 1.0, or 0.0 for a panel far away or thin, and behind it.

    min(w, d) > 0.03 |seen|: smaller ones look the same from everywhere, and their edges round in float32

    panel_width, panel_depth (...) m, seen (..., 3) m as panel_view. Returns (...). Errors: none.
    Source: Pharr et al. 2023, pbrt-v4, which samples small rectangles by area too.
    """
    seen = np.asarray(seen, float)
    large = np.minimum(panel_width, panel_depth) > 0.03 * np.sqrt(np.sum(seen * seen, -1))
    return ((seen[..., 2] > 0) & large).astype(float)


def panel_sample(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position, sampling, level, seed,
                 index):
    """Where a sample lies on the panel: kinds 0 to 3 by area, 4 and 5 even in solid angle from a point.

    panel_point at light_sample, or spherical_rectangle_point at it, turned back into the room

    light_x, light_y, light_height, panel_width, panel_depth (...) m, panel_tilt (...) rad, position (..., 3) m,
    sampling, level, seed, index (...) int. Returns (..., 3) m; behind the panel by area. Errors: as
    spherical_rectangle_point. Source: deck, Light Contribution of Area Lights (1); Urena, Fajardo, King 2013.
    """
    panel = light_x, light_y, light_height, panel_width, panel_depth, panel_tilt
    s, t, _ = np.moveaxis(light_sample(sampling, level, seed, index), -1, 0)
    by_area = panel_point(*panel, s, t)
    x0, x1, y0, y1, distance = _rectangle(*panel, position)
    seen = panel_view(light_x, light_y, light_height, panel_tilt, position)
    even = (np.asarray(sampling) >= 4) & (even_in_angle(panel_width, panel_depth, seen) > 0)
    p = spherical_rectangle_point(x0, x1, y0, y1, np.where(distance > 0, distance, 1), s, t)
    cos, sin = np.cos(panel_tilt), np.sin(panel_tilt)
    turned = np.stack([p[..., 0], p[..., 1] * cos - p[..., 2] * sin, p[..., 1] * sin + p[..., 2] * cos], -1)
    return np.where(even[..., None], position + turned, by_area)


def sample_flux(radiance, panel_width, panel_depth, level):
    """The flux of each of the punctual lights that stand for the panel; its intensity is L A cos_light / N.

    pi L A / N, A = w d, N = 4^level

    radiance (...) W/(m^2 sr), panel_width, panel_depth (...) m, level (...) int. Returns (...) W; they sum to the
    panel's. Errors: none. Source: deck, Light Contribution of Area Lights (1): "derived from the area light".
    """
    area = np.asarray(panel_width, float) * np.asarray(panel_depth, float)
    return np.pi * np.asarray(radiance, float) * area / 4.0 ** np.asarray(level)


def sample_share(to_sample):
    """What a sample gives per area, radiance and distance of its plane: the rest of cos cos_light / r^2.

    max(0, to_sample.z) / r^4, r = |to_sample|; cos = to_sample.z / r and cos_light = distance of the plane / r

    to_sample (..., 3) m, from the shaded point, its normal +z. Returns (...) 1/m^3. Errors: none.
    Source: deck, Light Contribution of Area Lights (1), with the emitter's cosine.
    """
    to_sample = np.asarray(to_sample, float)
    r2 = np.sum(to_sample * to_sample, -1)
    return np.maximum(to_sample[..., 2], 0) / r2 / r2


def irradiance_panel_sampled(radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position,
                             sampling, level, seed):
    """The irradiance on the floor from the panel, estimated by N = 4^level samples.

    By area (kinds 0 to 3) the mean of L cos cos_light A / r^2, even in solid angle (4 and 5) the weighted mean of
    L cos Omega; 0 behind the panel

    radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m, panel_tilt (...) rad,
    position (..., 3) m, sampling, level, seed (...) int. Returns (...) W/m^2. Errors: random falls like N^(-1/2),
    stratified like N^(-1), Sobol about N^(-1), a grid of middles N^(-1), Gauss-Legendre faster than any power up to
    level 3 where the horizon does not cut the panel. Sources: deck, Light Contribution of Area Lights (1); optics 5.
    """
    given = _floats(radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt)
    whole = np.broadcast_arrays(np.asarray(sampling), level, seed)
    place = np.asarray(position, float)
    shape = np.broadcast_shapes(given[0].shape, whole[0].shape, place.shape[:-1])
    given = [np.broadcast_to(g, shape).ravel() for g in given]
    kind, level, seed = (np.broadcast_to(g, shape).ravel() for g in whole)
    place = np.broadcast_to(place, (*shape, 3)).reshape(-1, 3)
    seen = panel_view(*given[1:4], given[6], place)
    angles = (kind >= 4) & (even_in_angle(*given[4:6], seen) > 0)
    value = np.zeros(kind.size)
    for of_kind, of_level in sorted(set(zip(kind.tolist(), level.tolist(), strict=True))):
        for by_angle in (False, True):
            here = np.flatnonzero((kind == of_kind) & (level == of_level) & (angles == by_angle))
            if here.size:
                args = [g[here] for g in given]
                value[here] = _estimate(args, place[here], of_kind, of_level, seed[here], by_angle)
    return value.reshape(shape)[()]


def _estimate(given, position, sampling, level, seed, by_angle):
    """The estimate at points (n,) with one kind and one level for all; in blocks of samples, to bound the memory."""
    radiance, *panel = given
    x0, x1, y0, y1, distance = _rectangle(*panel, position)
    front = distance > 0
    count, total = 4**level, np.zeros(len(radiance))
    z = np.where(front, distance, 1.0)
    sin, cos = np.sin(panel[5]), np.cos(panel[5])
    column = [np.asarray(v)[:, None] for v in (x0, x1, y0, y1, z)]
    for start in range(0, count, 4096):
        index = np.arange(start, min(count, start + 4096))
        s, t, weight = np.moveaxis(light_sample(sampling, level, seed[:, None], index), -1, 0)
        if not by_angle:
            way = panel_point(*(v[:, None] for v in panel), s, t) - position[:, None]
            total += np.sum(weight * sample_share(way), -1) * z
        else:
            p = spherical_rectangle_point(*column, s, t)
            up = p[..., 1] * sin[:, None] + p[..., 2] * cos[:, None]
            total += np.sum(weight * np.maximum(up, 0) / np.sqrt(np.sum(p * p, -1)), -1)
    size = solid_angle_rectangle_off_axis(x0, x1, y0, y1, z) if by_angle else panel[3] * panel[4]
    return np.where(front, radiance * size * total / count, 0.0)


def irradiance_panel_without_cosine(radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                                    position, level):
    """The irradiance from a grid of samples that each shine alike in every direction: the emitter's cosine forgotten.

    The mean of L cos A / r^2

    The arguments of irradiance_panel_sampled, samples in the middles of 2^level x 2^level cells. Returns (...) W/m^2.
    Errors: too much, by 1 / cos_light of each sample. Source: deck, Light Contribution of Area Lights (1), misread.
    """
    panel = light_x, light_y, light_height, panel_width, panel_depth, panel_tilt
    position, level = np.asarray(position, float), np.asarray(level)
    parts = [np.asarray(v)[..., None] for v in (*panel, level)]
    index = np.arange(4 ** int(np.max(level)))
    used = index < 4 ** parts[-1]
    s, t = np.moveaxis(grid_sample(np.where(used, index, 0), parts[-1]), -1, 0)
    way = panel_point(*parts[:-1], s, t) - position[..., None, :]
    share = np.sum(np.where(used, sample_share(way) * np.sqrt(np.sum(way * way, -1)), 0), -1) / 4.0**level
    front = panel_view(light_x, light_y, light_height, panel_tilt, position)[..., 2] > 0
    return np.where(front, np.asarray(radiance, float) * panel_width * panel_depth * share, 0.0)[()]
