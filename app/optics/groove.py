"""One V groove: two facets of length 1 that meet in a valley, ridges at z = 0, endlessly long along y.

`facet` is the signed angle of a facet's normal from n, positive where it leans to +x: (sin facet, 0, cos facet). `lean`
is that of a direction, seen along the groove. Only the other facet can stand in the way: all ridges are equally high.
"""

import numpy as np

FREE = 1e9

def groove_point(facet, t):
    """A point of a facet's profile: t goes from the valley up to the ridge.

    (-side t cos facet, 0, (t - 1) |sin facet|), side = 1 where the normal leans to +x or nowhere, else -1

    facet (...) rad, t (...) in [0, 1]. Returns (..., 3), in lengths of a facet. Errors: none.
    Source: Torrance and Sparrow 1967.
    """
    facet, t = np.broadcast_arrays(np.asarray(facet, float), np.asarray(t, float))
    side = np.where(facet < 0, -1.0, 1.0)
    return np.stack([-side * t * np.cos(facet), np.zeros_like(t), (t - 1) * np.abs(np.sin(facet))], -1)


def facet_lean(n, h):
    """The angle between the plate's normal and a facet's normal h.

    2 atan2(|h - n|, |h + n|)

    n, h (..., 3) unit vectors. Returns (...) rad. Errors: none. Source: Kahan 2006.
    """
    n, h = np.asarray(n, float), np.asarray(h, float)
    return 2 * np.arctan2(np.linalg.norm(h - n, axis=-1), np.linalg.norm(h + n, axis=-1))


def groove_lean(n, h, v):
    """The angle of a direction from n as one sees it along a groove whose facet has the normal h, positive towards h.

    atan2(v . t, v . n), t the unit vector of h - (n . h) n = n x ((h - n) x n): only this matters, as the groove is
    endlessly long

    n, h, v (..., 3) unit vectors. Returns (...) rad; where h = n, which is no groove, 0. Errors: none.
    Source: Torrance and Sparrow 1967; Blinn 1977.
    """
    n, h, v = (np.asarray(x, float) for x in (n, h, v))
    t = np.cross(n, np.cross(h - n, n))  # at right angles to n also where h is nearly n
    size = np.linalg.norm(t, axis=-1)
    across = np.sum(v * t, -1)
    return np.where(size > 0, np.arctan2(across, size * np.sum(v * n, -1)), 0.0)[()]


def groove_hidden(facet, lean):
    """The share of a facet that the other one hides from a direction: masked from the eye, shadowed from the light.

    -cos(facet + lean) / cos(facet - lean), at least 0, at most 1: (m' . v) / (m . v), where the line from the other
    ridge meets the facet; 1 where the facet is turned away, cos(facet - lean) <= 0. Hidden from the valley upwards.

    facet, lean (...) rad, within pi/2. Returns (...). Errors: none. Source: Torrance and Sparrow 1967; Blinn 1977.
    """
    facet, lean = np.asarray(facet, float), np.asarray(lean, float)
    facing = np.cos(facet - lean)
    share = -np.cos(facet + lean) / np.where(facing > 0, facing, 1.0)
    return np.where(facing > 0, np.clip(share, 0, 1), 1.0)[()]


def groove_reach(facet, t, lean):
    """How far the ray from the point t of a facet goes until the groove stops it; 1e9 where it never does.

    0 where it goes into its own facet; t |sin 2 facet| / -cos(facet + lean) to the other one, if it meets that between
    valley and ridge

    facet, lean (...) rad, t (...) in [0, 1]. Returns (...), in lengths of a facet. Errors: none; a ray through a ridge
    may go either way. Source: two lines crossing.
    """
    facet, t, lean = np.broadcast_arrays(*(np.asarray(x, float) for x in (facet, t, lean)))
    valley = groove_point(facet, 0.0)
    up, other = groove_point(facet, 1.0) - valley, groove_point(-facet, 1.0) - valley
    way = np.stack([np.sin(lean), np.zeros_like(lean), np.cos(lean)], -1)
    towards = -np.cos(facet + lean)  # positive: on to the other facet's front
    length = t * np.abs(np.sin(2 * facet)) / np.where(towards > 0, towards, 1.0)
    along = np.sum((t[..., None] * up + length[..., None] * way) * other, -1)  # from the valley to its ridge at 1
    meets = (towards > 0) & (length > 0) & (along >= 0) & (along <= 1)
    return np.where(np.cos(facet - lean) <= 0, 0.0, np.where(meets, length, FREE))[()]


def groove_blocked(facet, t, lean):
    """Whether the ray from the point t of a facet is stopped by the groove: 1.0 or 0.0.

    groove_reach < 1e9

    facet, lean (...) rad, t (...) in [0, 1]. Returns (...). Errors: none; a ray through a ridge may count either way.
    Source: two lines crossing; the closed form is groove_hidden.
    """
    return (groove_reach(facet, t, lean) < FREE).astype(float)[()]


def groove_hidden_counted(facet, lean, samples):
    """The share of a facet that is hidden from a direction, by counting rays from evenly spaced points.

    mean of groove_blocked at t = (i + 1/2) / samples

    facet, lean (...) rad, samples (...) >= 1. Returns (...), a multiple of 1 / samples. Errors: at most 1 / samples.
    Source: two lines crossing; the closed form is groove_hidden.
    """
    return _counted(lambda angle, t, towards: groove_blocked(angle, t, towards) == 1, facet, lean, samples)


def groove_open(facet, lean_l, lean_v):
    """The share of a facet that is both lit and seen: G.

    1 - max(groove_hidden(facet, lean_l), groove_hidden(facet, lean_v)), since both hidden parts begin in the valley;
    min(1, 2 n.m n.v / m.v, 2 n.m n.l / m.l)

    facet, lean_l, lean_v (...) rad. Returns (...). Errors: none. Source: Torrance and Sparrow 1967; Blinn 1977.
    """
    facet = np.asarray(facet, float)

    def shown(lean):
        facing = np.cos(facet - lean)
        share = 2 * np.cos(facet) * np.cos(lean) / np.where(facing > 0, facing, 1.0)
        return np.where(facing > 0, np.clip(share, 0, 1), 0.0)

    return np.minimum(shown(np.asarray(lean_l, float)), shown(np.asarray(lean_v, float)))[()]


def groove_open_counted(facet, lean_l, lean_v, samples):
    """The share of a facet that is both lit and seen, by counting: two rays from each of evenly spaced points.

    mean of (1 - groove_blocked towards the light) (1 - groove_blocked towards the eye) at t = (i + 1/2) / samples

    facet, lean_l, lean_v (...) rad, samples (...) >= 1. Returns (...), a multiple of 1 / samples.
    Errors: at most 1 / samples. Source: two lines crossing; the closed form is groove_open.
    """
    return _counted(lambda angle, t, light, eye: (groove_blocked(angle, t, light) == 0)
                    & (groove_blocked(angle, t, eye) == 0), facet, lean_l, lean_v, samples)


def _counted(holds, facet, *leans_and_samples):
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (facet, *leans_and_samples)))
    counts = []
    for angle, *leans, count in zip(*(g.ravel() for g in given), strict=True):
        counts.append(np.count_nonzero(holds(angle, (np.arange(int(count)) + 0.5) / count, *leans)))
    return (np.reshape(counts, given[0].shape) / given[-1])[()]


def groove_exchange(facet):
    """The share of the light a diffuse, evenly shining facet sends to the other one: what blocked light is worth.

    1 - cos facet = 2 sin^2(facet / 2)

    facet (...) rad. Returns (...). Errors: none. Source: Hottel 1954, crossed strings, of two facets with an edge.
    """
    return 2 * np.sin(0.5 * np.asarray(facet, float)) ** 2
