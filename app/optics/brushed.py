"""A brushed plate, 20 mm wide, whose grooves are 20 micrometres wide: what is seen of them at which enlargement."""

import numpy as np

PLATE, EYE = 20.0, np.deg2rad(1 / 60)  # mm; the finest detail a sharp eye resolves


def plate_shown(zoom):
    """The width of the part of the plate that fills the picture.

    20 mm / zoom

    zoom (...) >= 1. Returns (...) mm. Errors: none. Source: a choice; brushed steel has such grooves.
    """
    return PLATE / np.asarray(zoom, float)


def grooves_shown(zoom, groove_width):
    """How many grooves lie side by side in the picture.

    plate_shown / groove_width

    zoom (...) >= 1, groove_width (...) micrometres. Returns (...). Errors: none. Source: as plate_shown.
    """
    return 1000 * plate_shown(zoom) / groove_width


def resolved_distance(groove_width):
    """The distance up to which a sharp eye, which resolves one arc minute, sees single grooves.

    groove_width / (one arc minute)

    groove_width (...) micrometres. Returns (...) cm. Errors: one part in 10^8. Source: one arc minute is visus 1.0.
    """
    return 1e-4 * np.asarray(groove_width, float) / EYE
