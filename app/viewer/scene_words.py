"""What is written on the picture of a scene: legend, labels, the names of its marks, what is faulty in it."""

import numpy as np
from imgui_bundle import ImVec2, imgui

from app import camera as orbit
from app.gpu.picture import Faults
from app.gpu.stage import Stage
from app.theme import Theme, colour, rgb
from app.viewer import style
from app.viewer.cut import cut
from app.viewer.placing import Box, free

WIDEST, PLATE = 0.4, 0.82  # of a label: its share of the picture, and how little is seen through what it stands on
WRONG, WHITE = (0.75, 0.0, 0.1), (1.0, 1.0, 1.0)


class SceneWords:
    """Each stands on a plate of the background, for it may stand before anything, and where no other word stands."""

    def __init__(self, stage: Stage, points: dict[str, np.ndarray], corner: ImVec2, room: ImVec2, theme: Theme):
        self.stage, self.points, self.theme = stage, points, theme
        self.room = Box(corner.x, corner.y, room.x, room.y)
        self.taken: list[Box] = []

    def draw(self, faults: Faults | None) -> None:
        """Those that have one place only come first; that nothing is faulty stands in a corner that is left."""
        scene = self.stage.scene
        self.legend()
        if faults:
            self.fault_notice(faults)
        for label in scene.labels:
            words = cut(label.text, WIDEST * self.room.width)
            self.word(words, label.colour, self.points[f"label {label.probe}"], beside=False)
        for mark in scene.marks:
            if mark.label:
                gap = 1.1 if mark.tip != "none" else 0.4
                self.word(mark.label, mark.colour, self.points[f"mark {mark.name}"], gap)
        if faults is not None and not faults:
            self.sound()

    def word(self, text: str, name: str, point: np.ndarray, gap: float = 0.4, beside: bool = True) -> None:
        """A word beside its point or on it, as in stills; kept inside the picture. None for a point outside."""
        across, down, w = orbit.project(point, self.stage.matrix)
        if w <= 0 or not (-0.05 <= across <= 1.05 and -0.05 <= down <= 1.05):
            return
        size, room, gap = imgui.calc_text_size(text), self.room, gap * imgui.get_font_size()
        away = np.array([(across - 0.5) * room.width, (down - 0.5) * room.height])  # outwards, off the lines it names
        away = away / np.hypot(*away) if np.hypot(*away) > gap else np.array([0.0, -1.0])
        x = room.x + across * room.width + beside * away[0] * (gap + size.x / 2) - size.x / 2
        y = room.y + down * room.height + beside * away[1] * (gap + size.y / 2) - size.y / 2
        pad = 0.2 * size.y
        inside = Box(room.x + gap - pad, room.y + gap, room.width - 2 * (gap - pad), room.height - 2 * gap)
        box = free(Box(x - pad, y, size.x + 2 * pad, size.y), self.taken, inside, 1.0 if away[1] > 0 else -1.0)
        self.plate(box)
        ink = style.u32(style.ink(name, self.theme))
        imgui.get_window_draw_list().add_text(ImVec2(box.x + pad, box.y), ink, text)

    def plate(self, box: Box) -> None:
        self.taken.append(box)
        ground = style.u32(rgb(self.theme.background), PLATE)
        low = ImVec2(box.x + box.width, box.y + box.height)
        imgui.get_window_draw_list().add_rect_filled(ImVec2(box.x, box.y), low, ground, 0.5 * imgui.get_font_size())

    def legend(self) -> None:
        draw, size, corner = imgui.get_window_draw_list(), imgui.get_font_size(), self.room
        y, wide = corner.y + 0.6 * size, max(corner.width - 2.3 * size, 4 * size)
        for name, text in self.stage.scene.legend:
            needed = imgui.calc_text_size(text, wrap_width=wide)
            self.plate(Box(corner.x + 0.5 * size, y, needed.x + 1.6 * size, needed.y))
            sample = ImVec2(corner.x + 0.7 * size, y + 0.25 * size), ImVec2(corner.x + 1.4 * size, y + 0.95 * size)
            draw.add_rect_filled(*sample, style.u32(colour(name, self.theme)), 2.0)
            ink = style.u32(rgb(self.theme.foreground))
            draw.add_text(imgui.get_font(), size, ImVec2(corner.x + 1.8 * size, y), ink, text, wide)
            y += needed.y + imgui.get_style().item_spacing.y

    def sound(self) -> None:
        text, unit, room = "0 faulty pixels", imgui.get_font_size(), self.room
        size = imgui.calc_text_size(text)
        left = Box(room.x + 0.5 * unit, room.y + room.height - 1.2 * unit, size.x + 0.4 * unit, size.y)
        right = Box(room.x + room.width - 0.5 * unit - left.width, left.y, left.width, left.height)
        box = left if right.x < left.x or not any(left.meets(one) for one in self.taken) else right
        self.plate(box)
        at = ImVec2(box.x + 0.2 * unit, box.y)
        imgui.get_window_draw_list().add_text(at, style.u32(rgb(self.theme.quiet), 0.7), text)

    def fault_notice(self, faults: Faults) -> None:
        kinds = (faults.nan, "not a number"), (faults.inf, "infinite"), (faults.negative, "negative")
        text = "Faulty: " + ", ".join(f"{count} pixels {word}" for count, word in kinds if count)
        unit, room = imgui.get_font_size(), self.room
        wide = room.width - 1.5 * unit
        size = imgui.calc_text_size(text, wrap_width=wide)
        box = Box(room.x + 0.3 * unit, room.y + room.height - 1.2 * unit - size.y, size.x + 0.7 * unit,
                  size.y + 0.4 * unit)
        self.taken.append(box)
        draw, low = imgui.get_window_draw_list(), ImVec2(box.x + box.width, box.y + box.height)
        draw.add_rect_filled(ImVec2(box.x, box.y), low, style.u32(WRONG), 3.0)
        at = ImVec2(box.x + 0.35 * unit, box.y + 0.2 * unit)
        draw.add_text(imgui.get_font(), unit, at, style.u32(WHITE), text, wide)
