"""The editor of the step's GLSL, in the place of the prose: a function is typed, and picture, plots, numbers follow."""

import time

from imgui_bundle import ImVec2, imgui

from app import edit, own_models
from app.edit import SCENE, Function
from app.problem import Problem
from app.terms import whose
from app.viewer import style
from app.viewer.code_editor import CodeEditor

MOST = 0.55  # of the column, the code
REST = 0.5  # seconds without a key until what was typed is on disk


class EditorPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.is_open = False
        self.chosen: dict[str, str] = {}  # step -> the function that was edited last
        self.widget: CodeEditor | None = None
        self.of: tuple[str, str] = ("", "")  # the step and the function in the widget
        self.typed_at = 0.0  # 0: what was typed is on disk
        self.name = ""  # to save under
        self.listed: list[own_models.Saved] = []

    # --- what is asked of it -----------------------------------------------------------------------------------------
    def toggle(self) -> None:
        self.is_open = not self.is_open
        self.app.exercise.is_open = False

    def open(self, function: str) -> None:
        """The editor at a function; one that this step does not compile is a Problem."""
        self.app.session.function(function)
        self.chosen[self.app.session.current.id] = function
        self.is_open = True
        self.app.exercise.is_open = False

    @property
    def function(self) -> str:
        """The function in the editor: the one chosen, else one that was edited, else the first of glsl/optics."""
        session = self.app.session
        known = session.functions
        for name in (self.chosen.get(session.current.id, ""), *session.visit.texts):
            if name in known:
                return name
        return next((name for name, one in known.items() if one.include.startswith("optics/")), next(iter(known), ""))

    def typed(self, text: str) -> None:
        """What was typed runs at once, so that the next picture shows it."""
        self.app.session.type(self.of[1], text)
        self.typed_at = time.monotonic()
        self.app.own.write()

    def restore(self) -> None:
        session, name = self.app.session, self.function
        if name in session.visit.texts:
            session.restore(name)
        else:
            session.bring_back(name)
        self.app.own.write()

    # --- how it looks ------------------------------------------------------------------------------------------------
    def draw(self) -> None:
        session, name = self.app.session, self.function
        if not name:
            imgui.text_wrapped("This step compiles no function that could be edited.")
            return
        function = session.functions[name]
        self.choice(function)
        if self.of != (session.current.id, name) or self.widget is None:
            self.of, self.widget = (session.current.id, name), CodeEditor(session.text(name), on_change=self.typed)
            self.widget.focus()
        self.widget.set(session.text(name))
        wrong = self.app.own.trouble
        self.widget.mark(edit.complaints(wrong, name), self.app.theme)
        room = imgui.get_content_region_avail()
        self.widget.draw("code", ImVec2(0, min(self.widget.height(room.x), MOST * room.y)), self.app.theme)
        self.verdict(wrong, name)
        self.buttons(name)
        imgui.separator()
        imgui.begin_child("prose")
        self.app.text_column()
        imgui.end_child()

    def choice(self, function: Function) -> None:
        """Which function: those edited have a mark."""
        session = self.app.session
        imgui.set_next_item_width(-1)
        if imgui.begin_combo("##function", self.label(function), imgui.ComboFlags_.height_large):
            include = ""
            for one in session.functions.values():
                if one.include != include:
                    include = one.include
                    imgui.separator_text("the scene's own" if include == SCENE else one.file)
                if imgui.selectable(self.label(one), one.name == function.name)[0]:
                    self.open(one.name)
            imgui.end_combo()
        quiet(f"{function.file}, line {function.first}")

    def label(self, function: Function) -> str:
        texts = self.app.session.visit.texts
        return f"{function.name}{'  (edited)' if function.name in texts else ''}"

    def verdict(self, wrong: str, name: str) -> None:
        """Whether the text runs; what is wrong stands below it too, for the last row."""
        session, theme = self.app.session, self.app.theme
        if wrong:
            imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("r", theme)))
            imgui.text_wrapped(edit.first_complaint(wrong, name))
            imgui.pop_style_color()
            quiet("The picture shows the last text that ran.")
        elif session.visit.running:
            imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("v", theme)))
            imgui.text_wrapped("Your text runs, and all that is yours follows it.")
            imgui.pop_style_color()
            if any(whose(model.term, self.app.values) == "measured" for model in session.current.step.models):
                quiet("A measurement is a table, with no text that could be edited: it stays.")
        else:
            quiet("The course's text. Type, and the picture follows.")

    def buttons(self, name: str) -> None:
        visit = self.app.session.visit
        edited = name in visit.texts
        imgui.begin_disabled(not edited and name not in visit.aside)
        if imgui.button("Course's text" if edited or name not in visit.aside else "My text again"):
            self.restore()
        imgui.end_disabled()
        if imgui.is_item_hovered(imgui.HoveredFlags_.allow_when_disabled):
            imgui.set_tooltip("Ctrl+R: the course's text; again: yours")
        imgui.same_line()
        if imgui.button("Close"):
            self.is_open = False
        if imgui.is_item_hovered():
            imgui.set_tooltip("Esc, or E outside the text")
        unit = imgui.get_font_size()
        if imgui.get_content_region_avail().x > 25 * unit:
            imgui.same_line(0, 1.2 * unit)
        imgui.set_next_item_width(7 * unit)
        entered, self.name = imgui.input_text_with_hint("##name", "my_model", self.name,
                                                        imgui.InputTextFlags_.enter_returns_true)
        imgui.same_line()
        imgui.begin_disabled(not visit.running)
        if imgui.button("Save") or (entered and visit.running):
            self.save()
        imgui.end_disabled()
        if imgui.is_item_hovered(imgui.HoveredFlags_.allow_when_disabled):
            imgui.set_tooltip(f"Your text as a model of your own, in {own_models.folder()};\n"
                              f"`halfway board {self.name or 'my_model'}` opens it.")
        imgui.same_line()
        if imgui.button("Open"):
            self.listed = own_models.saved()
            imgui.open_popup("saved")
        self.opened()

    def save(self) -> None:
        app = self.app
        try:
            path = own_models.save(self.name, app.session.current, app.session.visit.running, app.session.values)
            app.message = f"saved as {path.name}" + (f"; halfway board {self.name}" if path.suffix == ".brdf" else "")
        except Problem as problem:
            app.message = str(problem)

    def opened(self) -> None:
        """What was saved: a click goes to its step and puts the texts there."""
        if not imgui.begin_popup("saved"):
            return
        if not self.listed:
            imgui.text_disabled("Nothing is saved yet.")
        for one in self.listed:
            if imgui.selectable(f"{one.name}   {', '.join(one.texts)} of {one.step}", False)[0]:
                self.reopen(one)
        imgui.end_popup()

    def reopen(self, one: own_models.Saved) -> None:
        app = self.app
        if app.session.current.id != one.step:
            app.go(one.step)
        try:
            for name, text in one.texts.items():
                app.session.put_aside(name)
                app.session.type(name, text)
                self.open(name)
        except Problem as problem:
            app.message = f"{one.name}: {problem}"
        self.name = one.name


def quiet(text: str) -> None:
    """Disabled text that breaks at the column's edge."""
    imgui.push_style_color(imgui.Col_.text, imgui.get_style_color_vec4(imgui.Col_.text_disabled))
    imgui.text_wrapped(text)
    imgui.pop_style_color()
