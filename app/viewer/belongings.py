"""What stands on the stage: the step's scene with its mesh and its tables, or the user's own files in their place."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from app import edit, leaving, maps, tables
from app.board.board_step import MOST, name_of
from app.board.models import FILES
from app.catalog import BOARD, LoadedStep
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.gpu.watch import watch
from app.ies import Photometry, read
from app.lesson import Scene
from app.meshes import Mesh, built_in, load
from app.picture_state import state_in
from app.problem import Problem


class Belongings:
    def __init__(self, app) -> None:
        self.app = app
        self.mesh: Mesh | None = None  # the user's own, in place of the scene's
        self.triangles: np.ndarray | None = None
        self.ies: Photometry | None = None  # the user's own luminaire, in place of the scene's
        self.tables: dict[str, np.ndarray] = {}
        self.maps: dict[str, maps.OwnMap] = {}  # the user's own, by their kind
        self.lamp = 0  # that was chosen when the user's luminaire came
        self.placed: tuple = ()  # the step and the mesh on the stage
        self.decided: tuple[leaving.Decision, ...] = ()  # what the scene does without, at the present values
        self.source = Source(Scene(""))  # of the step without it
        self.fault = ""  # why this step has no picture
        self.tried: tuple = ()  # the step and the texts that were compiled last
        self.wrong = ""  # what is wrong with the user's texts
        self.stuck = ""  # the loop of theirs that does not end at the present values
        self.watched: tuple = ()  # the texts and the values for which that was asked

    @property
    def data(self) -> dict[str, np.ndarray]:
        """What values carry beside the numbers: a mesh's triangles, a luminaire's table."""
        if self.triangles is None:
            return self.tables
        own = self.mesh is not None and self.triangles is self.mesh.triangles
        return {**self.tables, **(self.mesh.data if own and self.mesh else {"triangles": self.triangles})}

    @property
    def trouble(self) -> str:
        """What is wrong with the user's texts, as typed or at the present values."""
        return self.wrong or self.stuck

    @property
    def no_picture(self) -> str:
        """Why there is none."""
        return self.fault or self.stuck

    # --- files -------------------------------------------------------------------------------------------------------
    def take_file(self, path: str) -> None:
        """A file that was dropped or named, by its ending: a picture of ours brings its state back; a luminaire, a
        reflectance model, a map, else a mesh."""
        app = self.app
        try:
            kind = Path(path).suffix.lower()
            if kind == ".png" and (state := state_in(path)):
                app.session.go(state)
            elif kind in FILES:
                self.take_model(path)
            elif kind == ".ies":
                self.take_ies(path)
            elif kind in maps.ENDINGS:
                self.take_map(maps.guessed(path), path)
            else:
                self.take_mesh(path)
            app.show_welcome = False
        except Problem as problem:
            app.message = str(problem)

    def take_ies(self, path: str) -> None:
        """The user's own luminaire, in a step that has one."""
        found, session = read(path), self.app.session
        if not tables.has_luminaire(session.current.step.scene):
            session.go(next(s.id for s in session.steps if tables.has_luminaire(s.step.scene)))
        self.ies, self.lamp = found, int(session.values.get("luminaire", 0))
        self.app.message = found.summary

    def take_model(self, path: str) -> None:
        """The user's own model, on the board: beside what is there, or on a board of its own."""
        session = self.app.session
        words = [(one.word, one.on) for one in getattr(session.current, "entries", ())]
        others = [(word, on) for word, on in words if word != path]
        room = sum(on for _, on in others) < MOST
        session.examine(BOARD + name_of([*others, (path, room)]))
        entry = next(e for e in session.current.entries if e.word == path)
        self.app.message = entry.fault or ("" if room else f"{entry.label} is on the list; {MOST} models are shown.")

    def take_maps(self, given: tuple[str, ...]) -> None:
        """Those named on the command line, as kind=FILE."""
        said = []
        for kind, path in map(maps.named, given):
            try:
                self.take_map(kind, path)
            except Problem as problem:
                self.app.message = str(problem)
            said.append(self.app.message)
        self.app.message = " ".join(said) or self.app.message

    def take_map(self, kind: str, path: str) -> None:
        """The user's own map, in a step that has maps."""
        found, session = maps.read(kind, path), self.app.session
        if not tables.has_maps(session.current.step.scene):
            session.go(next(s.id for s in session.steps if tables.has_maps(s.step.scene)))
        self.maps[kind] = found
        session.revision += 1
        self.app.message = found.note + "."

    def take_mesh(self, path: str) -> None:
        """The user's own mesh, in the step about meshes."""
        session = self.app.session
        self.mesh = load(Path(path))
        if not any(s.mesh for s in session.current.step.scene.surfaces):
            session.go(next(s.id for s in session.steps if any(x.mesh for x in s.step.scene.surfaces)))
        if session.values.get("stands") == 0:  # on the board lobes stand where it would
            session.set("stands", 1)
        self.app.message = f"{self.mesh.name}: {self.mesh.note}"

    # --- the stage ---------------------------------------------------------------------------------------------------
    def mesh_named(self, shape: int) -> np.ndarray:
        return built_in(self.app.session.current.step.scene.meshes[shape]).triangles

    def place(self) -> None:
        """A stage for the step that is shown, with its mesh; made again when either changes."""
        session = self.app.session
        found, values = session.current, session.values
        by_hand = session.visit.decided | leaving.edited(found, session.visit.texts)
        self.decided = leaving.decisions(found, values, by_hand)
        source, found = edit.source_of(found), leaving.lean(found, self.decided)
        self.source = replace(source, scene=found.step.scene)
        if self.ies is not None and values.get("luminaire", self.lamp) != self.lamp:
            self.ies = None  # a luminaire was chosen: back to the scene's own
        self.tables = tables.chosen(found.step.scene, values, self.ies, self.maps)
        is_mesh = any(s.mesh for s in found.step.scene.surfaces)
        shape = int(values.get("shape", 0)) if is_mesh else -1
        # texts: it may be broken, or do without something
        wanted = (found.id, found.step.scene.texts), shape, id(self.mesh) if is_mesh else 0
        if wanted != self.placed:
            self.place_anew(found, wanted)
        self.write()
        self.watch()

    def place_anew(self, found: LoadedStep, wanted: tuple) -> None:
        shape = wanted[1]
        is_mesh = shape >= 0
        was, self.placed, self.fault = self.placed, wanted, ""
        if self.mesh is not None and was[:1] == wanted[:1] and was[1] not in (-1, shape):
            self.mesh, self.placed = None, (*wanted[:2], id(None))  # a shape was chosen: back to the scene's own
        self.triangles = None if not is_mesh else self.mesh.triangles if self.mesh else self.mesh_named(shape)
        scene = self.app.scene
        try:
            if was[:1] == wanted[:1] and scene.stage:
                scene.stage.place(self.triangles)
                scene.drawn = None
            else:
                self.tried = ()
                scene.show(Stage(self.app.ctx, self.source, self.triangles, self.app.session.values | self.tables))
        except Problem as problem:
            self.fault = str(problem)
        self.app.ctx.screen.use()

    def write(self) -> None:
        """The user's texts in the scene and in whatever evaluates its twins; while one is wrong, those before stay."""
        session, stage = self.app.session, self.app.scene.stage
        found, known = session.current, session.functions
        texts = {name: text for name, text in session.texts.items() if name in known}
        if stage is None or self.tried == (found.id, texts):
            return
        self.tried, self.wrong = (found.id, texts), ""
        try:
            for name, text in texts.items():
                edit.check(text, known[name])
            stage.rewrite(edit.overrides(texts, known, self.source), lambda: self.try_out(stage))
        except Problem as problem:
            self.wrong = str(problem)
        else:
            session.run(texts)
            self.app.scene.drawn = None
        self.app.ctx.screen.use()

    def watch(self) -> None:
        """Whether the loops of the texts that run end, asked again when something has changed."""
        session, stage = self.app.session, self.app.scene.stage
        if stage is None or not (stage.source.overrides or stage.scene.texts):
            self.stuck, self.watched = "", ()
            return
        now = session.current.id, session.revision, stage.source, *map(id, self.data.values())
        if now == self.watched:
            return
        self.watched, self.stuck = now, ""
        try:
            self.try_out(stage)
        except Problem as problem:
            self.stuck = str(problem)

    def try_out(self, stage: Stage) -> None:
        watch(stage, self.app.values, self.app.session.view.camera(stage.scene.camera))
        self.app.ctx.screen.use()
