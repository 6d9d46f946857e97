"""The plot beside the scene: wished for when something changed, drawn elsewhere, shown when it comes."""

from imgui_bundle import ImVec2, imgui


class PlotPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.waiting = False

    def draw(self, values, room: ImVec2) -> None:
        imgui.dummy(room)

    def close(self) -> None:
        pass
