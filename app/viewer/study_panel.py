"""The points of a study in the plot: what the one under the pointer is, and a click that sets the scene to it."""

import textwrap

from imgui_bundle import ImVec2, imgui

from app.lesson import Number
from app.plots.wire import Spot
from app.problem import Usage

WIDE = 60  # letters of a line of the tooltip
NEAR = 0.9  # heights of the text from a point


def nearest(spots: tuple[Spot, ...], x: float, y: float, reach: float) -> Spot | None:
    """The point of the picture nearest to a place, px; one that a click sets goes before one it does not."""
    def far(spot: Spot) -> float:
        return ((spot.x - x) ** 2 + (spot.y - y) ** 2) ** 0.5

    near = [spot for spot in spots if far(spot) <= reach]
    return min(near, key=lambda spot: (not spot.sets, far(spot)), default=None)


class StudyPanel:
    def __init__(self, app) -> None:
        self.app = app

    def point(self, spots: tuple[Spot, ...], at: ImVec2) -> None:
        """After the plot's own button: the pointer over it, in the picture's pixels."""
        if not spots or not imgui.is_item_hovered():
            return
        mouse, scale = imgui.get_mouse_pos(), imgui.get_io().display_framebuffer_scale
        unit = imgui.get_font_size()
        found = nearest(spots, (mouse.x - at.x) * scale.x, (mouse.y - at.y) * scale.y, NEAR * unit * scale.x)
        if found is None:
            imgui.set_tooltip(textwrap.fill(self.app.session.plot.why, WIDE))
            return
        sets = self.possible(found)
        imgui.set_tooltip(found.words + ("\nClick: the scene with this method and as many samples." if sets else ""))
        if sets:
            imgui.set_mouse_cursor(imgui.MouseCursor_.hand)
        if sets and imgui.is_mouse_clicked(0):
            self.choose(sets)

    def possible(self, spot: Spot) -> dict[str, Number]:
        """What of it the step has as a value, as near as its range allows."""
        found: dict[str, Number] = {}
        for name, value in spot.sets.items():
            spec = self.app.session.current.values.get(name)
            if spec is not None and not isinstance(value, tuple):
                near = min(max(value, spec.low), spec.high)
                found[name] = int(near) if spec.quantity.kind == "int" else near
        return found

    def choose(self, sets: dict[str, Number]) -> None:
        session = self.app.session
        try:
            session.change({**session.values, **sets}, session.view)
        except Usage:  # the picture is frozen until the guess
            return
