"""Cells of the sphere between circles of latitude and meridians (deck, slide Basic Concepts)."""

import numpy as np


def grid_cell(theta, rows):
    """Solid angle of one cell of a grid with `rows` rows and 2 `rows` columns, cut off at the poles.

    2 sin((t0 + t1) / 2) sin((t1 - t0) / 2) dphi, with t0, t1 = theta -+ pi / (2 rows) kept within [0, pi]

    theta: polar angle of the cell's middle, rad; rows: count >= 1. Arrays broadcast. Returns sr. Exact: the difference
    of cosines, written as a product so that it does not cancel. Source: deck, slide Basic Concepts.
    """
    theta, high = np.asarray(theta, float), np.pi / np.asarray(rows, float)
    above, below = np.minimum(theta, high / 2), np.minimum(np.pi - theta, high / 2)
    return 2 * np.sin(theta + (below - above) / 2) * np.sin((above + below) / 2) * high


def grid_cell_differential(theta, rows):
    """The same cell to first order, as an integral over directions is written.

    sin(theta) dtheta dphi, dtheta = dphi = pi / rows

    theta: rad; rows: count. Returns sr; relative error dtheta^2 / 24 away from the poles. Source: slide Basic Concepts.
    """
    high = np.pi / np.asarray(rows, float)
    return np.sin(np.asarray(theta, float)) * high * high


def grid_cell_widest(rows):
    """Polar angle of the middle of the row whose cells are largest; of two equal ones, the upper.

    (floor((rows - 1) / 2) + 1/2) pi / rows

    rows: count >= 1. Returns rad; pi / 2 for odd rows. Source: sin(theta) is largest at the equator.
    """
    rows = np.asarray(rows)
    return ((rows - 1) // 2 + 0.5) * np.pi / rows
