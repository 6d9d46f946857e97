"""The fold below the prose: the very lines that run, from the file, highlighted; each leads to the editor."""

from imgui_bundle import ImVec2, imgui

from app.edit import SCENE, Function, spoken_of
from app.viewer.code_editor import CodeEditor


class LinesPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.shown: dict[str, CodeEditor] = {}  # of this step, by function
        self.of = ""

    def draw(self) -> None:
        session = self.app.session
        if not imgui.tree_node("The lines that run"):
            return
        if self.of != session.current.id:
            self.of, self.shown = session.current.id, {}
        known = session.functions
        first = [name for name in spoken_of(session.current) if name in known]
        others = [name for name, one in known.items() if name not in first and one.include != SCENE]
        for i, name in enumerate([*first, *others]):
            self.function(known[name], i == 0)
        imgui.tree_pop()

    def function(self, function: Function, opened: bool) -> None:
        name = function.name
        running = self.app.session.visit.running.get(name)
        imgui.set_next_item_open(opened, imgui.Cond_.appearing)
        if not imgui.tree_node(name):
            return
        imgui.text_disabled(f"{function.file}, line {function.first}" if running is None else "your text")
        imgui.same_line()
        if imgui.small_button(f"Edit##{name}"):
            self.app.editor.open(name)
        text = running or function.text
        if name not in self.shown or self.shown[name].text != text:
            self.shown[name] = CodeEditor(text, read_only=True)
        widget, width = self.shown[name], imgui.get_content_region_avail().x
        widget.draw(f"lines {name}", ImVec2(width, widget.height(width)), self.app.theme)
        imgui.tree_pop()
