"""Plays a scene: draws it into its own picture, answers its probes, counts its faults."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, cast

import moderngl
import numpy as np

from app import camera as orbit
from app import loops
from app.gpu.context import endless, pixel, program
from app.gpu.evaluate import data_texture
from app.gpu.stage_text import COLOURS, LINES, TIP_SIZE, TIPS, Programs, Source, grid, look, pen, programs
from app.lesson import Camera, Mark, Surface
from app.mesh_edges import corner_normals
from app.problem import Problem
from app.shader import Assembled, Overrides
from app.theme import Theme, rgb

WITHOUT = np.zeros((1, 3, 3))  # texture coordinates of a mesh that has none
SAMPLES = 4  # a picture at rest; while something moves it is drawn with one
OVER: Any = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA
MANY = 8  # surfaces for which each is worth a program of its own: they are compiled before the first picture


@dataclass(frozen=True)
class Faults:
    """Pixels whose radiance is not a number, infinite or negative."""

    nan: int = 0
    inf: int = 0
    negative: int = 0

    def __bool__(self) -> bool:
        return bool(self.nan or self.inf or self.negative)


def give(use: moderngl.Program, **values) -> None:
    """Set the uniforms a program has among the given ones."""
    known = use.extra = use.extra or {name: use[name] for name in use}  # `in` a program goes through all its names
    for name in known.keys() & values.keys():
        uniform, value = cast(Any, known[name]), values[name]
        if isinstance(value, bytes):
            uniform.write(value[:uniform.element_size * uniform.array_length])
        else:
            uniform.value = value


def on_gpu(values: dict) -> dict:
    """The step's values as uniforms; data that is no uniform (a mesh) stays behind."""
    return {name: value for name, value in values.items() if not isinstance(value, np.ndarray)}


class Stage:
    one_program = False  # for all surfaces, rather than one for each

    def __init__(self, ctx: moderngl.Context, source: Source, triangles: np.ndarray | None = None):
        self.ctx, self.source, self.scene = ctx, source, source.scene
        self.size, self.matrix, self.line_width = (0, 0), np.eye(4), 2.0
        self.geometry: dict[str, tuple] = {}  # name -> (buffer, layout, attribute), indices
        self.arrays: dict[tuple[str, str], moderngl.VertexArray] = {}
        self.programs: dict[str, moderngl.Program] = {}
        self.parts: dict[tuple[str, bool], Any] = {}  # what is drawn into: (name, fine)
        self.targets: dict[tuple[tuple[str, ...], bool], moderngl.Framebuffer] = {}
        self.data: dict[str, tuple[np.ndarray, moderngl.Texture]] = {}  # uniform -> what it holds; units in this order
        self.passing: dict = {}  # programs of texts that are being edited
        self.watched: Programs = {}  # those with a loop of the user's
        with ctx:
            self.compile(None)
            self.place(triangles)

    def rewrite(self, overrides: Overrides, trial: Callable[[], None] = lambda: None) -> None:
        """Other texts in the scene. One that does not compile is a Problem, and so is one that fails in the `trial`;
        what was drawn before goes on.

        All surfaces share a program then: a text is compiled once, which a hand that types waits for."""
        if overrides == self.source.overrides:
            return
        before, runs = (self.source, self.programs, self.watched, self.arrays), False
        self.source, self.arrays = replace(self.source, overrides=overrides), {}
        try:
            with self.ctx:
                self.programs = self.compiled(None)
            trial()
            runs = True
        finally:
            unused = before[3] if runs else self.arrays
            if not runs:
                self.source, self.programs, self.watched, self.arrays = before
            with self.ctx:
                for array in unused.values():
                    array.release()
                for key in [key for key, use in self.passing.items() if use not in self.programs.values()]:
                    self.passing.pop(key).release()

    def compile(self, names: tuple[str, ...] | None) -> None:
        self.programs |= self.compiled(names)

    def settle(self, values: dict, camera: Camera, theme: Theme) -> bool:
        """Where surfaces share a program one more gets its own, compiled for every kind of picture: for idle moments,
        as it takes a tenth of a second. False: there is none left. The picture stays what it was, with soft edges."""
        shared = {i: program_of(surface) for i, surface in enumerate(self.scene.surfaces)}
        shared = {i: use for i, use in shared.items() if use in self.programs and f"{use} {i}" not in self.programs}
        if not shared:
            return False
        todo, use = next(iter(shared.items()))
        vertex, fragment = self.texts((use,))[use]
        assert fragment
        with self.ctx:
            own = program(self.ctx, only(todo, vertex), only(todo, fragment), (), self.passing_now)
        self.programs[f"{use} {todo}"] = own
        for fine, counted in ((False, False), (False, True), (True, False)):
            self.draw(values, camera, self.size, theme, fine, counted)
        return True

    @property
    def passing_now(self) -> dict | None:
        """Where the programs of a text that is being edited are kept."""
        return self.passing if self.source.overrides else None

    def compiled(self, names: tuple[str, ...] | None) -> dict[str, moderngl.Program]:
        found: dict[str, moderngl.Program] = {}
        texts = self.texts(names)
        if names is None:
            self.watched = {name: pair for name, pair in texts.items()
                            if any(part and loops.COUNT in part.text for part in pair)}
        passing = self.passing_now
        one = self.one_program or passing is not None or len(self.scene.surfaces) > MANY
        for name, (vertex, fragment) in texts.items():
            if fragment and name in ("surface", "mesh") and not one:
                for i in (i for i, s in enumerate(self.scene.surfaces) if program_of(s) == name):
                    found[f"{name} {i}"] = program(self.ctx, only(i, vertex), only(i, fragment), (), passing)
            else:
                values = () if fragment else ("value", "v_endless") if name in self.watched else ("value",)
                found[name] = program(self.ctx, vertex, fragment, values, passing)
        return found

    def texts(self, names: tuple[str, ...] | None) -> Programs:
        source = self.source
        return programs(self.scene, source.file, source.first, names=names,
                        overrides=source.overrides, watched=True)

    # --- constant data ---------------------------------------------------------------------------------------------
    def place(self, triangles: np.ndarray | None) -> None:
        """Put the scene's constant arrays on the GPU; `triangles` (faces, 3, 3) is the step's mesh."""
        self.release_geometry()
        for i, surface in enumerate(self.scene.surfaces):
            if not surface.mesh:
                self.keep(f"surface {i}", "2f", "stage_st", *grid(surface.cells))
            elif triangles is not None:
                self.keep(f"surface {i}", "3f", "stage_position", np.ascontiguousarray(triangles, "f4"))
                self.hold("triangles", triangles)
                if any("texture_coordinates" in use for use in self.programs.values()):
                    self.hold("texture_coordinates", WITHOUT)
                if any("normals" in use for use in self.programs.values()):
                    self.hold("normals", corner_normals(triangles))
        for uniform, path in self.scene.measured:
            from app.board import merl

            self.hold(uniform, merl.read(path).table)
        for i, mark in enumerate(self.scene.marks):
            self.keep(f"mark {i}", "3f", "stage_corner", *pen(mark.segments, mark.tip != "none"))

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
        if (use, name) not in self.arrays:
            data, indices = self.geometry.get(name, (None, None))
            content = [data] if data and data[2] in self.programs[use] else []
            self.arrays[use, name] = self.ctx.vertex_array(self.programs[use], content, indices)
        return self.arrays[use, name]

    # --- drawing ---------------------------------------------------------------------------------------------------
    def draw(self, values: dict, camera: Camera, size: tuple[int, int], theme: Theme,
             fine: bool = True, counted: bool = True) -> moderngl.Texture:
        """The picture at these values, the same texture until the size changes: with soft edges when `fine`, and with
        the count of its faults when `counted` (it takes a third longer: a window counts when nothing moves)."""
        self.aim(values, camera, size, theme)
        with self.ctx:
            fine = fine and self.ctx.max_samples >= SAMPLES
            drawn_into = ("picture", "faults") if counted else ("picture",)
            target = self.target(drawn_into, fine)
            before = self.ctx.fbo
            target.clear(*rgb(theme.background), 1.0)
            if counted:
                self.target(("faults",), fine).clear()
            target.use()  # last: clearing a framebuffer without depth leaves the depth mask off
            self.paint(values, target)
            if fine:
                self.ctx.copy_framebuffer(self.target(drawn_into, False), target)
            before.use()
            return self.part("picture", False)

    def aim(self, values: dict, camera: Camera, size: tuple[int, int], theme: Theme) -> None:
        """All that a picture depends on. From now on probes answer for it, and at once: they wait for what is drawn."""
        with self.ctx:
            self.resize(size)
            self.take_tables(values)
            self.set_uniforms(values, camera, theme)

    def resize(self, size: tuple[int, int]) -> None:
        size = max(1, int(size[0])), max(1, int(size[1]))
        if size == self.size:
            return
        limit = self.ctx.info["GL_MAX_TEXTURE_SIZE"]
        if max(size) > limit:
            raise Problem(f"a picture of {size[0]} x {size[1]} pixels is larger than this OpenGL can draw ({limit}).")
        self.release_targets()
        self.size = size

    def target(self, names: tuple[str, ...], fine: bool) -> moderngl.Framebuffer:
        """A framebuffer of these parts, with depth where there is a picture; made when it is first wanted."""
        if (names, fine) not in self.targets:
            depth = self.part("depth", fine) if "picture" in names else None
            self.targets[names, fine] = self.ctx.framebuffer([self.part(name, fine) for name in names], depth)
        return self.targets[names, fine]

    def part(self, name: str, fine: bool) -> Any:
        if (name, fine) not in self.parts:
            samples = SAMPLES if fine else 0
            self.parts[name, fine] = (
                self.ctx.depth_renderbuffer(self.size, samples=samples) if name == "depth" else
                self.ctx.texture(self.size, 4) if name == "picture" and not fine else
                self.ctx.renderbuffer(self.size, 4, samples=samples))
        return self.parts[name, fine]

    def paint(self, values: dict, target: moderngl.Framebuffer) -> None:
        """Opaque surfaces, then dots and marks, then what one looks through."""
        ctx = self.ctx
        ctx.enable_only(moderngl.DEPTH_TEST | moderngl.PROGRAM_POINT_SIZE)
        solid = [i for i, s in enumerate(self.scene.surfaces) if s.opacity >= 1]
        for i in solid:
            self.paint_surface(i)
        ctx.enable(moderngl.BLEND)
        ctx.blend_func = OVER
        if "dots" in self.programs:
            self.paint_dots(values)
        for i, mark in enumerate(self.scene.marks):
            self.paint_mark(i, mark)
        target.depth_mask = False
        for i in range(len(self.scene.surfaces)):
            if i not in solid:
                self.paint_surface(i)
        target.depth_mask = True
        ctx.enable_only(moderngl.NOTHING)

    def paint_surface(self, i: int, suffix: str = "") -> None:
        surface = self.scene.surfaces[i]
        if f"surface {i}" not in self.geometry:
            return
        name = f"{program_of(surface)} {suffix or i}"
        name = name if name in self.programs else program_of(surface)
        self.bind_data(self.programs[name])
        give(self.programs[name], surface=i, opacity=surface.opacity)
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
        steps = 0 if mark.line == "solid" and mark.tip != "arrow" else 1 if mark.segments == 1 else 16
        self.bind_data(self.programs["mark"])
        give(self.programs["mark"], mark=i, measure_steps=steps, length_steps=steps if mark.tip == "arrow" else 0,
             mark_colour=COLOURS.index(mark.colour),
             dash=LINES.index(mark.line), tip=TIPS.index(mark.tip), line_width=width,
             tip_size=TIP_SIZE[mark.tip] * width)
        self.array("mark", f"mark {i}").render()

    def dot_count(self, values: dict) -> int:
        count = self.scene.dots.count if self.scene.dots else 0
        return int(values[count]) if isinstance(count, str) else count

    def set_uniforms(self, values: dict, camera: Camera, theme: Theme) -> None:
        self.matrix = orbit.view_projection(camera, self.size[0] / self.size[1])
        self.line_width = theme.line * max(0.75, min(self.size) / 620)
        dot = (2.0 + self.line_width) * (self.scene.dots.size if self.scene.dots else 1.0)
        stage = look(theme) | {"view_projection": self.matrix.T.astype("f4").tobytes(), "viewport": self.size,
                               "camera_position": tuple(orbit.position(camera)), "dot_size": dot}
        for use in self.programs.values():
            give(use, **on_gpu(values), **stage)

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
            use = self.programs[name]
            self.take_tables(given)
            self.bind_data(use)
            give(use, **on_gpu(given))
            width = 4 + (name in self.watched)
            before, out = self.ctx.fbo, self.ctx.buffer(reserve=4 * width * count)
            pixel(self.ctx).use()
            self.array(name).transform(out, moderngl.POINTS, count)
            before.use()
            answer = np.frombuffer(out.read(), "f4").reshape(count, width)
            out.release()
            if lines := answer[:, 4:].copy().view("i4").max(initial=0):
                raise endless(int(lines), self.watched[name][0])
            return answer[:, :4].astype(float)

    def faults(self) -> Faults:
        """The faulty pixels of the last picture that was counted."""
        with self.ctx:
            counted = self.target(("picture", "faults"), False)
            found = np.frombuffer(counted.read(components=4, attachment=1), "u1").reshape(-1, 4)
        if not np.count_nonzero(found.view("<u4") & 0xFFFFFF):
            return Faults()
        return Faults(*(int(np.count_nonzero(found[:, i])) for i in range(3)))

    def pixels(self) -> np.ndarray:
        """uint8 (height, width, 3), the top row first."""
        with self.ctx:
            data = np.frombuffer(self.target(("picture",), False).read(components=3, alignment=1), "u1")
        return data.reshape(self.size[1], self.size[0], 3)[::-1]

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

    def release_targets(self) -> None:
        for thing in (*self.targets.values(), *self.parts.values()):
            thing.release()
        self.targets, self.parts, self.size = {}, {}, (0, 0)

    def release(self) -> None:
        """Give back everything but the programs, which the context keeps for the next stage."""
        with self.ctx:
            self.release_geometry()
            self.release_targets()
            for use in self.passing.values():
                use.release()


def program_of(surface: Surface) -> str:
    return "mesh" if surface.mesh else "surface"


def only(i: int, text: Assembled) -> Assembled:
    """A program for one surface: its number a constant, so that what the scene does for the others falls away.

    A CPU (llvmpipe) runs both sides of every branch; this makes its frames up to twice as fast.
    """
    return replace(text, text=text.text.replace("uniform int surface;", f"const int surface = {i};"))
