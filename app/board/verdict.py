"""The badges of a model of colour: each the worst of its three channels."""

from collections.abc import Callable

import numpy as np

from app.badges import SAME, Badge, check


def worst_of(reflect: Callable[..., np.ndarray], channels: int = 3, same: float = SAME) -> dict[str, Badge]:
    """reflect(n, l, v, channel) in 1/sr; `same` as in `check`."""
    found = [check(lambda n, l, v, channel=channel: reflect(n, l, v, channel), same=same)
             for channel in range(channels)]
    return {name: max((badges[name] for badges in found), key=lambda b: severity(name, b)) for name in found[0]}


def severity(name: str, badge: Badge) -> tuple[bool, float]:
    """What makes one channel's badge worse than another's."""
    worst = np.inf if badge.worst is None else badge.worst
    return not badge.ok, -worst if name == "non_negative" else worst
