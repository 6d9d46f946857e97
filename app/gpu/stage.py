"""Plays a scene: draws it into its own picture, answers its probes."""

from collections.abc import Callable
from typing import Any

import moderngl
import numpy as np

from app import camera as orbit
from app.gpu.context import endless, pixel
from app.gpu.evaluate import data_texture
from app.gpu.picture import SAMPLES, Picture
from app.gpu.scene_programs import ScenePrograms, program_of
from app.gpu.stage_text import TIP_SIZE, Source, grid, look, mark_uniforms, pen
from app.gpu.uniforms import give, on_gpu
from app.lesson import Camera, Mark
from app.mesh_edges import corner_normals
from app.problem import Problem
from app.shader import Overrides
from app.theme import Theme, rgb

WITHOUT = np.zeros((1, 3, 3))  # texture coordinates of a mesh that has none
OVER: Any = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA


class Stage:
    kind: type[ScenePrograms] = ScenePrograms

    def __init__(self, ctx: moderngl.Context, source: Source, triangles: np.ndarray | None = None,
                 values: dict | None = None):
        """`values`: of the first picture, for what the scene decides; without one it is the first of each choice."""
        self.ctx, self.scene = ctx, source.scene
        self.picture, self.matrix, self.line_width = Picture(ctx), np.eye(4), 2.0
        self.geometry: dict[str, tuple] = {}  # name -> (buffer, layout, attribute), indices
        self.arrays: dict[tuple[moderngl.Program, str], moderngl.VertexArray] = {}
        self.data: dict[str, tuple[np.ndarray, moderngl.Texture]] = {}  # uniform -> what it holds; units in this order
        with ctx:
            self.own = self.kind(ctx, source, values or {}, self.forget)
            self.place(triangles)

    # --- programs --------------------------------------------------------------------------------------------------
    @property
    def source(self) -> Source:
        return self.own.source

    @property
    def programs(self) -> dict[str, moderngl.Program]:
        return self.own.made.programs

    def rewrite(self, overrides: Overrides, trial: Callable[[], None] = lambda: None) -> None:
        """Other texts in the scene, where they compile and pass the `trial`; else a Problem, and all is as before."""
        if overrides != self.source.overrides:
            self.own.rewrite(overrides, trial)

    def decide(self, values: dict) -> None:
        if self.own.decide(values):
            self.hold_mesh()

    def forget(self, gone: moderngl.Program) -> None:
        for key in [key for key in self.arrays if key[0] is gone]:
            self.arrays.pop(key).release()

    def settle(self, values: dict, camera: Camera, theme: Theme) -> bool:
        """Where surfaces share a program one more gets its own, compiled for every kind of picture: for idle moments,
        as it takes a tenth of a second. False: there is none left. The picture stays what it was, with soft edges."""
        with self.ctx:
            if not self.own.one_more():
                return False
        for fine, counted in ((False, False), (False, True), (True, False)):
            self.draw(values, camera, self.picture.size, theme, fine, counted)
        return True

    # --- constant data ---------------------------------------------------------------------------------------------
    def place(self, triangles: np.ndarray | None) -> None:
        """Put the scene's constant arrays on the GPU; `triangles` (faces, 3, 3) is the step's mesh."""
        self.release_geometry()
        for i, surface in enumerate(self.scene.surfaces):
            if not surface.mesh:
                self.keep(f"surface {i}", "3f", "stage_position", *grid(surface.cells))
            elif triangles is not None:
                self.keep(f"surface {i}", "3f", "stage_position", np.ascontiguousarray(triangles, "f4"))
                self.hold("triangles", triangles)
        self.hold_mesh()
        for uniform, path in self.scene.measured:
            from app.board import merl

            self.hold(uniform, merl.read(path).table)
        for i, mark in enumerate(self.scene.marks):
            self.keep(f"mark {i}", "3f", "stage_corner", *pen(mark.segments, mark.tip != "none"))

    def hold_mesh(self) -> None:
        """Of a mesh what the programs read beside its corners."""
        if "triangles" not in self.data:
            return
        for name in ("texture_coordinates", "normals"):
            if name not in self.data and any(name in use for use in self.programs.values()):
                self.hold(name, WITHOUT if name == "texture_coordinates" else corner_normals(self.data["triangles"][0]))

    def hold(self, uniform: str, data: np.ndarray) -> None:
        """Constant data the scene reads by texelFetch; sent once as long as it is the same array."""
        held = self.data.get(uniform)
        if held is None or held[0] is not data:
            if held:
                held[1].release()
            self.data[uniform] = data, data_texture(self.ctx, data)

    def take_tables(self, values: dict) -> None:
        """The scene's tables, and its mesh's own texture coordinates, by the names of their uniforms."""
        own = values.get("texture_coordinates")
        if own is not None and "texture_coordinates" in self.data:
            self.hold("texture_coordinates", own)
        for table in self.scene.tables:
            if table.uniform in values:
                self.hold(table.uniform, values[table.uniform])
            elif table.uniform not in self.data:
                raise Problem(f"the scene needs the table {table.uniform}, and it is not among its values.")

    def bind_data(self, use: moderngl.Program) -> None:
        for unit, (uniform, (_, texture)) in enumerate(self.data.items()):
            if uniform in use:
                texture.use(unit)
                give(use, **{uniform: unit})

    def keep(self, name: str, layout: str, attribute: str, corners: np.ndarray,
             indices: np.ndarray | None = None) -> None:
        self.geometry[name] = ((self.ctx.buffer(corners), layout, attribute),
                               None if indices is None else self.ctx.buffer(indices))

    def array(self, use: str, name: str = "") -> moderngl.VertexArray:
        """The vertex array that feeds the program `use` with the geometry `name`."""
        key = made, _ = self.programs[use], name
        if key not in self.arrays:
            data, indices = self.geometry.get(name, (None, None))
            content = [data] if data and data[2] in made else []
            self.arrays[key] = self.ctx.vertex_array(made, content, indices)
        return self.arrays[key]

    # --- drawing ---------------------------------------------------------------------------------------------------
    def draw(self, values: dict, camera: Camera, size: tuple[int, int], theme: Theme,
             fine: bool = True, counted: bool = True) -> moderngl.Texture:
        """The picture at these values, the same texture until the size changes: with soft edges when `fine`, and with
        the count of its faults when `counted` (it takes a third longer: a window counts when nothing moves)."""
        self.aim(values, camera, size, theme)
        with self.ctx:
            fine = fine and self.ctx.max_samples >= SAMPLES
            drawn_into = ("picture", "faults") if counted else ("picture",)
            target = self.picture.target(drawn_into, fine)
            before = self.ctx.fbo
            target.clear(*rgb(theme.background), 1.0)
            if counted:
                self.picture.target(("faults",), fine).clear()
            target.use()  # last: clearing a framebuffer without depth leaves the depth mask off
            self.paint(values, target)
            if fine:
                self.ctx.copy_framebuffer(self.picture.target(drawn_into, False), target)
            before.use()
            return self.picture.texture

    def aim(self, values: dict, camera: Camera, size: tuple[int, int], theme: Theme) -> None:
        """All that a picture depends on. From now on probes answer for it, and at once: they wait for what is drawn."""
        with self.ctx:
            self.picture.resize(size)
            self.decide(values)
            self.take_tables(values)
            self.set_uniforms(values, camera, theme)

    def paint(self, values: dict, target: moderngl.Framebuffer) -> None:
        """Opaque surfaces, then dots and marks, then what one looks through."""
        ctx = self.ctx
        ctx.enable_only(moderngl.DEPTH_TEST | moderngl.PROGRAM_POINT_SIZE)
        shown = [i for i, s in enumerate(self.scene.surfaces) if not s.where or values.get(s.where[0]) == s.where[1]]
        solid = [i for i in shown if self.scene.surfaces[i].opacity >= 1]
        for i in solid:
            self.paint_surface(i)
        ctx.enable(moderngl.BLEND)
        ctx.blend_func = OVER
        if "dots" in self.programs:
            self.paint_dots(values)
        for i, mark in enumerate(self.scene.marks):
            self.paint_mark(i, mark)
        target.depth_mask = False
        for i in shown:
            if i not in solid:
                self.paint_surface(i)
        target.depth_mask = True
        ctx.enable_only(moderngl.NOTHING)

    def drawn_by(self, i: int, suffix: str = "") -> str:
        """The program of a surface: its own, or the one it shares; all share one of another kind, by its suffix."""
        return f"{program_of(self.scene.surfaces[i])} {suffix}" if suffix else self.own.made.drawn_by[i]

    def paint_surface(self, i: int, suffix: str = "") -> None:
        surface = self.scene.surfaces[i]
        if f"surface {i}" not in self.geometry:
            return
        name = self.drawn_by(i, suffix)
        self.bind_data(self.programs[name])
        give(self.programs[name], surface=i, is_mesh=int(surface.mesh), opacity=surface.opacity)
        array = self.array(name, f"surface {i}")
        if not surface.mesh or surface.opacity < 1:
            array.render()
            return
        self.ctx.enable(moderngl.CULL_FACE)  # a mesh's far side behind its near one: depth leaves it uncoloured
        for away in ("back", "front"):
            self.ctx.cull_face = away
            array.render()
        self.ctx.disable(moderngl.CULL_FACE)

    def paint_dots(self, values: dict) -> None:
        self.bind_data(self.programs["dots"])
        self.array("dots").render(moderngl.POINTS, self.dot_count(values))

    def paint_mark(self, i: int, mark: Mark) -> None:
        width = self.line_width * mark.width
        self.bind_data(self.programs["mark"])
        give(self.programs["mark"], **mark_uniforms(i, mark), line_width=width, tip_size=TIP_SIZE[mark.tip] * width)
        self.array("mark", f"mark {i}").render()

    def dot_count(self, values: dict) -> int:
        count = self.scene.dots.count if self.scene.dots else 0
        return int(values[count]) if isinstance(count, str) else count

    def set_uniforms(self, values: dict, camera: Camera, theme: Theme) -> None:
        size = self.picture.size
        self.matrix = orbit.view_projection(camera, size[0] / size[1])
        self.line_width = theme.line * max(0.75, min(size) / 620)
        dot = (2.0 + self.line_width) * (self.scene.dots.size if self.scene.dots else 1.0)
        stage = look(theme) | {"view_projection": self.matrix.T.astype("f4").tobytes(), "viewport": size,
                               "camera_position": tuple(orbit.position(camera)), "dot_size": dot}
        for use in self.programs.values():
            give(use, **on_gpu(self.scene, values), **stage)

    # --- answers ---------------------------------------------------------------------------------------------------
    def probes(self, values: dict) -> np.ndarray:
        """`probe(i)` for every probe the labels and handles name: (n, 4)."""
        wanted = [*(label.probe for label in self.scene.labels), *(handle.probe for handle in self.scene.handles)]
        if not wanted:
            return np.zeros((0, 4))
        return self.transform("probe", max(wanted) + 1, **values)

    def anchors(self, values: dict) -> dict[str, np.ndarray]:
        """Where each mark's label stands: name -> point in the world."""
        return {mark.name: self.transform("anchor", 1, mark=i, mark_t=mark.label_at, **values)[0, :3]
                for i, mark in enumerate(self.scene.marks) if mark.label}

    def transform(self, name: str, count: int, **given) -> np.ndarray:
        with self.ctx:
            self.decide(given)
            use = self.programs[name]
            self.take_tables(given)
            self.bind_data(use)
            give(use, **on_gpu(self.scene, given))
            width = 4 + (name in self.own.made.watched)
            before, out = self.ctx.fbo, self.ctx.buffer(reserve=4 * width * count)
            pixel(self.ctx).use()
            self.array(name).transform(out, moderngl.POINTS, count)
            before.use()
            answer = np.frombuffer(out.read(), "f4").reshape(count, width)
            out.release()
            if lines := answer[:, 4:].copy().view("i4").max(initial=0):
                raise endless(int(lines), self.own.made.watched[name][0])
            return answer[:, :4].astype(float)

    # --- the end ---------------------------------------------------------------------------------------------------
    def release_geometry(self) -> None:
        for array in self.arrays.values():
            array.release()
        for data, indices in self.geometry.values():
            data[0].release()
            if indices is not None:
                indices.release()
        for _, texture in self.data.values():
            texture.release()
        self.arrays, self.geometry, self.data = {}, {}, {}

    def release(self) -> None:
        """Give back everything but the programs, which the context keeps for the next stage."""
        with self.ctx:
            self.release_geometry()
            self.picture.release()
            self.own.release()
