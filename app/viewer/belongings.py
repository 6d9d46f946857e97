"""What stands on the stage: the step's scene with its mesh and its tables, or the user's own files in their place."""

from pathlib import Path

import numpy as np

from app import tables
from app.board.board_step import MOST, name_of, words_of
from app.board.models import FILES
from app.catalog import BOARD
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.ies import Photometry, read
from app.meshes import Mesh, built_in, load
from app.problem import Problem


class Belongings:
    def __init__(self, app) -> None:
        self.app = app
        self.mesh: Mesh | None = None  # the user's own, in place of the scene's
        self.triangles: np.ndarray | None = None
        self.ies: Photometry | None = None  # the user's own luminaire, in place of the scene's
        self.tables: dict[str, np.ndarray] = {}
        self.lamp = 0  # that was chosen when the user's luminaire came
        self.placed: tuple = ()  # the step and the mesh on the stage
        self.fault = ""  # why this step has no picture

    @property
    def data(self) -> dict[str, np.ndarray]:
        """What values carry beside the numbers: a mesh's triangles, a luminaire's table."""
        return {**self.tables, **({} if self.triangles is None else {"triangles": self.triangles})}

    # --- files -------------------------------------------------------------------------------------------------------
    def take_file(self, path: str) -> None:
        """A file that was dropped or named: a luminaire or a reflectance model by its ending, else a mesh."""
        app = self.app
        try:
            if Path(path).suffix.lower() in FILES:
                self.take_model(path)
            elif Path(path).suffix.lower() == ".ies":
                self.take_ies(path)
            else:
                self.take_mesh(path)
            app.show_welcome = False
        except Problem as problem:
            app.message = str(problem)

    def take_ies(self, path: str) -> None:
        """The user's own luminaire, in a step that has one."""
        found, session = read(path), self.app.session
        if not session.current.step.scene.tables:
            session.go(next(s.id for s in session.steps if s.step.scene.tables))
        self.ies, self.lamp = found, int(session.values.get("luminaire", 0))
        self.app.message = found.summary

    def take_model(self, path: str) -> None:
        """The user's own model, on the board: beside what is there, or on a board of its own."""
        session = self.app.session
        words = words_of(session.current.step.name) if session.current.id.startswith(BOARD) else []
        others = [(word, on) for word, on in words if word != path]
        room = sum(on for _, on in others) < MOST
        session.examine(BOARD + name_of([*others, (path, room)]))
        entry = next(e for e in session.current.entries if e.word == path)
        self.app.message = entry.fault or ("" if room else f"{entry.label} is on the list; {MOST} models are shown.")

    def take_mesh(self, path: str) -> None:
        """The user's own mesh, in the step about meshes."""
        session = self.app.session
        self.mesh = load(Path(path))
        if not any(s.mesh for s in session.current.step.scene.surfaces):
            session.go(next(s.id for s in session.steps if any(x.mesh for x in s.step.scene.surfaces)))
        self.app.message = f"{self.mesh.name}: {self.mesh.note}"

    # --- the stage ---------------------------------------------------------------------------------------------------
    def mesh_named(self, shape: int) -> np.ndarray:
        return built_in(self.app.session.current.step.scene.meshes[shape]).triangles

    def place(self) -> None:
        """A stage for the step that is shown, with its mesh; made again when either changes."""
        found, values = self.app.session.current, self.app.session.values
        if self.ies is not None and values.get("luminaire", self.lamp) != self.lamp:
            self.ies = None  # a luminaire was chosen: back to the scene's own
        self.tables = tables.chosen(found.step.scene, values, self.ies)
        is_mesh = any(s.mesh for s in found.step.scene.surfaces)
        shape = int(values.get("shape", 0)) if is_mesh else -1
        wanted = (found.id, found.step.scene.texts), shape, id(self.mesh) if is_mesh else 0  # texts: it may be broken
        if wanted == self.placed:
            return
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
                source = Source(found.step.scene, found.file_name, found.glsl_line)
                scene.show(Stage(self.app.ctx, source, self.triangles))
        except Problem as problem:
            self.fault = str(problem)
        self.app.ctx.screen.use()
