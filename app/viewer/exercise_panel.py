"""An exercise beside its scene, in the place of the prose: what is asked, what is typed, what the checks say of it."""

import time
from concurrent.futures import Future, ThreadPoolExecutor
from functools import cache
from pathlib import Path

from imgui_bundle import ImVec2, imgui

from app import edit
from app.catalog import LoadedStep
from app.exercises import Checker, Language, hand_in, of_step, taught
from app.lesson import Exercise
from app.practice import Practice
from app.problem import Problem
from app.theme import colour
from app.viewer import glfw, style, verdicts_view
from app.viewer.code_editor import CodeEditor

MOST = 0.42  # of the column, the code
REST = 0.35  # seconds without a key until what was typed is checked and kept
LANGUAGES: tuple[tuple[Language, str], ...] = (("glsl", "GLSL"), ("python", "Python"))


class ExercisePanel:
    def __init__(self, app) -> None:
        self.app = app
        self.is_open = False
        self.practice = Practice(app.progress)
        self.checker = Checker(on_verdicts=glfw.wake)
        self.chosen: dict[str, str] = {}  # chapter -> the exercise that was chosen there
        self.widget: CodeEditor | None = None
        self.of: tuple = ()  # the exercise and the language in the widget
        self.typed_at = 0.0  # 0: what was typed is checked and kept
        self.thread = ThreadPoolExecutor(1, "hand in")
        self.handing: Future | None = None
        self.handed: tuple[str, str] = ("", "")  # the exercise, and what became of handing in
        self.folder = ""  # where to hand in

    # --- what is asked of it -----------------------------------------------------------------------------------------
    @property
    def known(self) -> dict[str, Exercise]:
        return of_step(self.app.session.current)

    @property
    def own(self) -> list[str]:
        """Those that the step teaches."""
        return [name for name, one in self.known.items() if taught(self.app.session.current, one)]

    @property
    def name(self) -> str:
        """The exercise that is shown: the one chosen in this chapter, else the step's own."""
        known, found = self.known, self.app.session.current
        chosen = self.chosen.get(found.loaded.id, "")
        return chosen if chosen in known else next(iter(known), "")

    @property
    def language(self) -> Language:
        return self.practice.language(self.name)

    @property
    def is_shown(self) -> bool:
        return self.is_open and bool(self.name)

    @property
    def is_drawn(self) -> bool:
        """Whether the scene is drawn by what is typed here."""
        return self.language == "glsl" and self.known[self.name].function in self.app.session.functions

    def toggle(self) -> None:
        self.open("" if not self.is_shown else None)

    def open(self, name: str | None) -> None:
        """This exercise, or ("") the step's; None closes."""
        app = self.app
        if name is not None and not self.known:
            app.message = "This chapter has no exercise."
            return
        self.is_open = name is not None
        if name:
            self.chosen[app.session.current.loaded.id] = name
        app.editor.is_open &= not self.is_open

    def place(self) -> None:
        """What is typed stands in the scene, while it is open and the scene is made of it."""
        session, name = self.app.session, self.name
        texts = {}
        if self.is_shown and self.language == "glsl":
            exercise = self.known[name]
            texts = {exercise.function: self.practice.text(name, exercise, "glsl")}
        session.try_out(texts)

    def typed(self, text: str) -> None:
        """It is drawn at once, checked and kept when the hand rests."""
        name, language = self.of
        self.practice.type(name, self.known[name], language, text)
        self.handed = "", ""
        self.typed_at = time.monotonic()

    def rest(self) -> None:
        """Called every frame: checks and keeps what was typed a moment ago."""
        shown = self.checker.shown
        if shown and shown.ok and not self.practice.solved(shown.exercise):
            self.practice.solve(shown.exercise)
            self.app.session.save()
        if self.typed_at and time.monotonic() - self.typed_at > REST:
            self.typed_at = 0.0
            self.app.session.save()
        if self.is_shown and not self.typed_at:
            name, language = self.name, self.language
            self.checker.ask(name, self.practice.text(name, self.known[name], language), language)
        if self.handing and self.handing.done():
            self.handed, self.handing = (self.handed[0], self.handing.result()), None

    def restart(self) -> None:
        """The stub; again: what was typed."""
        name, language = self.name, self.language
        if self.practice.typed(name, language):
            self.practice.start_again(name, language)
        else:
            self.practice.bring_back(name, language)
        self.typed_at = time.monotonic()

    def hand_in(self) -> None:
        """The file of the chapter's assignment, with what is written in this language."""
        name, language = self.name, self.language
        texts = {one: self.practice.text(one, exercise, language) for one, exercise in self.known.items()
                 if self.practice.typed(one, language)}
        folder = Path(self.folder).expanduser()
        self.app.progress.put_setting("hand_in_folder", self.folder)
        self.handed = name, ""
        self.handing = self.thread.submit(handed_in, name, language, texts, folder)
        self.handing.add_done_callback(lambda _: glfw.wake())

    def close(self) -> None:
        self.checker.on_verdicts = lambda: None
        self.thread.shutdown(wait=True, cancel_futures=True)

    # --- how it looks ------------------------------------------------------------------------------------------------
    def draw(self) -> None:
        name, language = self.name, self.language
        exercise = self.known[name]
        self.choice(name)
        imgui.text_wrapped(exercise.task)
        self.scene_words(name, exercise)
        text = self.practice.text(name, exercise, language)
        if self.of != (name, language) or self.widget is None:
            self.of, self.widget = (name, language), CodeEditor(text, language, self.typed)
            self.widget.focus()
        self.widget.set(text)
        shown = self.checker.shown
        mine = shown if shown and shown.of[:2] == self.of else None
        self.widget.mark(self.faults(exercise, mine, text), self.app.theme)
        room = imgui.get_content_region_avail()
        self.widget.draw("code", ImVec2(0, min(self.widget.height(room.x), MOST * room.y)), self.app.theme)
        imgui.spacing()
        self.buttons(name, language)
        imgui.separator()
        imgui.begin_child("verdicts")
        verdicts_view.draw(mine, self.app.theme, is_old=mine is None or mine.text != text)
        imgui.end_child()

    def choice(self, name: str) -> None:
        """Which exercise of the chapter, and in which language."""
        unit, language = imgui.get_font_size(), self.language
        pad, gap = 2 * imgui.get_style().frame_padding.x, 0.3 * unit
        wide = sum(imgui.calc_text_size(words).x + pad for _, words in LANGUAGES) + gap + 0.8 * unit
        imgui.set_next_item_width(imgui.get_content_region_avail().x - wide)
        if imgui.begin_combo("##exercise", self.label(name)):
            for one in self.known:
                if imgui.selectable(self.label(one), one == name)[0]:
                    self.open(one)
            imgui.end_combo()
        for i, (one, words) in enumerate(LANGUAGES):
            imgui.same_line(0, gap if i else 0.8 * unit)
            if one == language:
                imgui.push_style_color(imgui.Col_.button, imgui.get_style_color_vec4(imgui.Col_.button_active))
            if imgui.button(words):
                self.practice.write_in(name, one)
            if one == language:
                imgui.pop_style_color()

    def label(self, name: str) -> str:
        return f"Exercise: {self.known[name].function}{'  (solved)' if self.practice.solved(name) else ''}"

    def scene_words(self, name: str, exercise: Exercise) -> None:
        """Whether the scene is drawn by it; if not, where it would be."""
        app = self.app
        if self.is_drawn:
            wrong = app.own.trouble
            ink = style.ink("r", app.theme) if wrong else colour("quiet", app.theme)
            imgui.push_style_color(imgui.Col_.text, style.vec(ink))
            imgui.text_wrapped("The picture shows your last text that ran." if wrong else
                               "The scene is drawn by your text, and all that is yours follows it.")
            imgui.pop_style_color()
            return
        is_python = self.language == "python"
        imgui.push_style_color(imgui.Col_.text, style.vec(colour("quiet", app.theme)))
        imgui.text_wrapped("Python is checked; the scene stays the course's." if is_python else
                           "It is checked; this scene is made of other functions.")
        imgui.pop_style_color()
        there = "" if is_python else drawn_in(name, app.session.steps)
        if there and imgui.small_button("To a scene that your text draws"):
            self.open(name)
            app.go(there)

    def faults(self, exercise: Exercise, shown, text: str) -> list[tuple[int, str]]:
        """The lines that the compiler of the scene complains of, else those that the checks name."""
        if self.is_drawn and self.app.own.trouble:
            return edit.complaints(self.app.own.trouble, exercise.function)
        return verdicts_view.faults(shown) if shown and shown.text == text else []

    def buttons(self, name: str, language: Language) -> None:
        practice = self.practice
        typed, aside = practice.typed(name, language), practice.can_go_back(name, language)
        if imgui.button("Hand in"):
            self.folder = self.app.progress.setting("hand_in_folder", str(self.app.progress.folder / "homework"))
            imgui.open_popup("hand in")
        self.where(language)
        imgui.same_line()
        imgui.begin_disabled(not typed and not aside)
        if imgui.button("Start again" if typed or not aside else "My text again"):
            self.restart()
        imgui.end_disabled()
        if imgui.is_item_hovered(imgui.HoveredFlags_.allow_when_disabled):
            imgui.set_tooltip("Ctrl+R: the text to start from; again: yours")
        imgui.same_line()
        if imgui.button("Close"):
            self.open(None)
        if imgui.is_item_hovered():
            imgui.set_tooltip("Esc, or X outside the text")
        if self.handing:
            imgui.text_disabled("writing and checking…")
        elif self.handed[0] == name and self.handed[1]:
            imgui.text_wrapped(self.handed[1])

    def where(self, language: Language) -> None:
        """Asks for the folder."""
        if not imgui.begin_popup("hand in"):
            return
        unit = imgui.get_font_size()
        imgui.push_text_wrap_pos(28 * unit)
        imgui.text_wrapped("Your texts of this chapter as one file to hand in, in this folder:")
        imgui.pop_text_wrap_pos()
        imgui.set_next_item_width(28 * unit)
        entered, self.folder = imgui.input_text("##folder", self.folder, imgui.InputTextFlags_.enter_returns_true)
        if (imgui.button("Write the file") or entered) and self.folder.strip():
            self.hand_in()
            imgui.close_current_popup()
        imgui.end_popup()


def handed_in(name: str, language: Language, texts: dict[str, str], folder: Path) -> str:
    """What a person is told of it."""
    try:
        done = hand_in(name, language, texts, folder)
    except Problem as problem:
        return f"Not written: {problem}"
    passing = f"{done.good} of its {done.count} functions pass{'es' if done.good == 1 else ''} every visible check"
    return f"Written: {done.path}. {passing}{f' ({done.said})' if done.said else ''}."


@cache
def drawn_in(name: str, steps: tuple[LoadedStep, ...]) -> str:
    """A step of its chapter whose scene is made of the exercise's function: best one that teaches it."""
    own = [(step, of_step(step)[name]) for step in steps if name in of_step(step)]
    own.sort(key=lambda pair: not taught(*pair))
    return next((step.id for step, exercise in own if exercise.function in edit.functions(step)), "")


def invitation(app) -> None:
    """Below the prose of a step: a button for each exercise that it teaches."""
    panel = app.exercise
    for name in panel.own:
        solved = panel.practice.solved(name)
        if imgui.button(f"Exercise: write {panel.known[name].function}{'  (solved)' if solved else ''}"):
            panel.open(name)
        if imgui.is_item_hovered():
            imgui.set_tooltip(f"{panel.known[name].task}  (X)")
