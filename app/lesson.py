"""What a chapter is made of: frozen data that refuses unknown words. A scene placed here can be played by any stage.

What depends on a value lives in GLSL (the scene's functions) or is the name of a twin in `optics`; all else is
constant.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from app.classroom import Break, Check, Choice, Exercise, LeaveOut, Prediction  # noqa: F401  lessons import all here
from app.worded import Number, Term, Worded, vocabulary  # noqa: F401

Colour = Literal["n", "l", "v", "h", "r", "exact", "estimate", "printed", "lost", "d", "g", "f", "quiet"]


@dataclass(frozen=True)
class Value(Worded):
    """A quantity of the step a student can change: its name in `quantities`, and where this step narrows the table.

    Angles are in degrees, as on screen. Every uniform of the scene that the table knows is a value without a word here.
    """

    name: str
    default: Number | None = None
    low: float | None = None
    high: float | None = None
    scale: Literal["", "linear", "log"] = ""  # "": as in quantities
    more: bool = False  # behind "more"
    choices: tuple[str, ...] = ()  # an integer value whose numbers have names


@dataclass(frozen=True)
class Model(Worded):
    """A reflectance of the step: a twin `brdf_*` (1/sr, without the cosine) or `shading_*` (L_o / L_i) of n, l, v.

    It has badges, and plots show its lobe. Its other arguments are the step's values; a twin with an argument
    `radiance` gives L_o for that L_i; one with an argument `channel` has a lobe for red, green and blue.
    """

    label: str
    term: Term
    colour: Colour = "estimate"

    @property
    def is_shading(self) -> bool:
        return self.term.function.startswith("shading_")


@dataclass(frozen=True)
class Surface:
    """A grid of cells that `vec3 surface_point(int surface, vec2 s)` places, or the step's mesh placed by
    `vec3 mesh_point(int surface, vec3 p)`; `vec3 shade(Surface s)` colours it. Its number is its place in the
    scene. What is dear and smooth, or the same all over, is computed at the corners only, and is s.value in shade:
    `vec4 surface_value(int surface, vec2 s)` or `vec4 mesh_value(int surface, vec3 p, int face)`."""

    name: str
    cells: tuple[int, int] = (48, 24)
    opacity: float = 1.0
    mesh: bool = False
    where: tuple[str, int] | None = None  # a value and its number; at others nothing is seen of it, nor drawn


@dataclass(frozen=True)
class Mark(Worded):
    """A line that `vec3 mark_point(int mark, float t)` places, t from 0 to 1, in the grammar of colour and line."""

    name: str
    colour: Colour = "exact"
    line: Literal["solid", "dashed", "dotted", "dashdot"] = "solid"
    tip: Literal["none", "arrow", "sun", "eye", "dot"] = "none"
    segments: int = 1  # more than one for an arc
    width: float = 1.0  # times the theme's line width
    label: str = ""
    label_at: float = 1.0  # the t of the label


@dataclass(frozen=True)
class Dots:
    """Points that `vec3 dot_point(int i)` places and `vec4 dot_colour(int i)` colours (alpha 0 hides one)."""

    count: int | str = 0  # a number, or the value that holds it
    size: float = 1.0


@dataclass(frozen=True)
class Label(Worded):
    """Words at the point `vec4 probe(int i)`."""

    text: str
    probe: int
    colour: Colour = "exact"


@dataclass(frozen=True)
class Handle:
    """A thing to grab, at the point `vec4 probe(int i)`: a drag changes `values` so that the point follows the hand."""

    name: str
    probe: int
    values: tuple[str, ...]


@dataclass(frozen=True)
class Table(Worded):
    """Constant numbers with a name of their own: a `sampler2D` of the scene and an argument of its twins.

    One of the built-in `files` (of lessons/ies), chosen by the value `choice`; a user's file replaces it. Or a user's
    map of that kind: four channels, the fourth 0 as long as there is none, and the scene's own formula holds."""

    uniform: str
    files: tuple[str, ...] = ()
    choice: str = ""
    map: Literal["", "albedo", "f0", "roughness", "normal"] = ""
    given: str = ""  # a `uniform int` that is 1 where there is a map of the user's, else 0; a scene may decide it


@dataclass(frozen=True)
class Text:
    """GLSL written elsewhere (`file`, from line `first` on) that a scene includes by this name: a user's model."""

    name: str
    text: str
    file: str
    first: int = 1


@dataclass(frozen=True)
class Camera:
    azimuth: float = -50.0  # degrees, from +x towards +y
    elevation: float = 22.0  # degrees
    distance: float = 6.0
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    field_of_view: float = 30.0  # degrees, vertical


@dataclass(frozen=True)
class Scene:
    glsl: str
    surfaces: tuple[Surface, ...] = ()
    marks: tuple[Mark, ...] = ()
    dots: Dots | None = None
    labels: tuple[Label, ...] = ()
    handles: tuple[Handle, ...] = ()
    camera: Camera = Camera()
    meshes: tuple[str, ...] = ()  # built-in ones, chosen by the value `shape`; a user's file replaces them
    legend: tuple[tuple[Colour, str], ...] = ()
    tables: tuple[Table, ...] = ()
    negative: dict[str, tuple[float, float]] = field(default_factory=dict)  # where negative light is meant: from, to
    texts: tuple[Text, ...] = ()
    measured: tuple[tuple[str, str], ...] = ()  # a `sampler2D` of the scene, and the MERL file whose numbers it holds
    decided: tuple[str, ...] = ()  # choices, each a line `uniform int NAME;`, constant in a program
    brush: bool = False  # a click picks the normal `vec3 shading_normal(Surface s)` as display/brush.glsl means it

    @property
    def of_the_user(self) -> tuple[str, ...]:
        """Whole uniforms that no value of the step sets: 1 where a map, or the mesh's coordinates, are the user's."""
        return *(table.given for table in self.tables if table.given), "own_coordinates"


@dataclass(frozen=True)
class Readout(Worded):
    """A live number: a twin at the step's values, in float64, or in float32 as the GPU computes it."""

    label: str
    term: Term
    role: Literal["exact", "estimate", "printed", "number"] = "number"
    precision: Literal["float64", "float32"] = "float64"
    unit: str = "sr"
    against: str = ""  # the label of the exact readout this one's error is taken against
    absent: str = ""  # what is said where there is no such number (NaN)


@dataclass(frozen=True)
class Curve(Worded):
    label: str
    term: Term
    role: Literal["exact", "estimate", "printed"] = "exact"
    precision: Literal["float64", "float32"] = "float64"
    colour: str = ""  # its own, "#RRGGBB", where it is the colour of a thing; else the role's


@dataclass(frozen=True)
class Curves(Worded):
    """Twins against one swept value; the step's present value is marked. `error` plots |f/f_exact - 1| instead."""

    title: str
    sweep: str
    curves: tuple[Curve, ...]
    y_label: str
    y_scale: Literal["linear", "log"] = "linear"
    x_scale: Literal["linear", "log", ""] = ""  # "": as in quantities
    error: bool = False
    most: float = 0.0  # where a linear axis ends at the latest, above 0: what goes beyond it is cut there, and named
    tab: str = ""  # a word for its tab


@dataclass(frozen=True)
class Sheet(Worded):
    """A surface in a plot: a twin that gives a point for (s, t) in the unit square, as it is or projected."""

    label: str
    term: Term
    onto: Literal["", "sphere", "disk"] = ""  # from the origin onto the unit sphere, or on down to the base disk
    colour: Colour = "estimate"
    cells: tuple[int, int] = (48, 48)
    opacity: float = 1.0
    height: Term | None = None  # colours the sheet by this twin's value at (s, t)
    height_label: str = ""


@dataclass(frozen=True)
class Figure(Worded):
    """Sheets in space, with the unit hemisphere or sphere and the base disk where asked."""

    title: str
    sheets: tuple[Sheet, ...] = ()
    dome: Literal["", "hemisphere", "sphere"] = ""
    disk: bool = False
    camera: Camera = Camera()


@dataclass(frozen=True)
class Faces:
    """The step's mesh in a plot, each face coloured by the solid angle it subtends at the value `eye`."""

    title: str
    camera: Camera = Camera()


@dataclass(frozen=True)
class LedgerRow:
    """A quantity of a ledger; it is the one before it times a factor whose unit is `by` ("": a mere number)."""

    label: str
    term: Term
    unit: str
    by: str = ""
    how: str = ""  # what the factor is, in a word or two


@dataclass(frozen=True)
class Ledger:
    """Quantities below each other, in columns, their dimensions checked; and a balance: emitted, received, escaped."""

    title: str
    columns: tuple[tuple[LedgerRow, ...], ...]
    balance: tuple[Term, Term, Term] | None = None
    unit: str = ""  # of the balance


@dataclass(frozen=True)
class Lobes(Worded):
    """The lobes of models over the hemisphere, overlaid, at the step's theta_l, theta_v and phi: where the light of l
    goes, or (`over` "l") from where light reaches v. Without models it shows the step's. A value `lobe_scale` of the
    step switches between f, f times n.l and log f; a model of `channel` has three lobes."""

    title: str
    models: tuple[Model, ...] = ()
    over: Literal["v", "l"] = "v"
    camera: Camera = Camera(azimuth=-90, elevation=16, distance=4.3, target=(0.0, 0.0, 0.42))


@dataclass(frozen=True)
class Slice(Worded):
    """The same lobes cut by the plane of n and the still direction: a polar plot, or the value against the angle."""

    title: str
    models: tuple[Model, ...] = ()
    over: Literal["v", "l"] = "v"
    kind: Literal["polar", "angle"] = "polar"
    tab: str = ""


@dataclass(frozen=True)
class ImageSlice:
    """A model in its own coordinates: the halfway vector's angle theta_h to the right, the difference angle theta_d
    upwards, at phi_d = 90 degrees (Burley 2012). The step's value `model` chooses one of several."""

    title: str
    models: tuple[Model, ...] = ()


@dataclass(frozen=True)
class Method:
    """A way to the quantity of a study: a `rule` of app/study, points and a map like "sobol importance"; or a twin
    whose argument `cost` grows along the `ladder` (`level`: 4^level samples). A click on a point sets the twin's
    arguments in the step, or what `sets` says, "N" standing for the samples and "rung" for its place on the ladder."""

    label: str
    rule: str = ""
    term: Term | None = None
    cost: str = ""
    ladder: tuple[int, ...] = ()  # none: the rule's own
    sets: dict[str, Number | str] = field(default_factory=dict)


@dataclass(frozen=True)
class Study(Worded):
    """Error against run time: what a quantity costs by several methods. It is what their twins estimate, or the
    integral of a product of twins over "directions" (all l, times n.l), "halfways" (all h, times n.h), the "sphere"
    (all `towards`), "angles" (all theta and phi) or "wavelengths". `halfway study` looks at all `cases`; an error is
    the worst over `worst`. `sampler` names sample_* and pdf_*, `width` how wide the lobe is. `exact`
    is a twin, a sum of twins, a value's name, a number, or a method that has no rival."""

    title: str
    exact: Term | tuple[Term, ...] | Method | float | str
    methods: tuple[Method, ...]
    why: str  # why the winner wins
    over: Literal["", "directions", "halfways", "sphere", "angles", "wavelengths"] = ""
    integrand: tuple[Term, ...] = ()
    sampler: str = ""
    width: str | Term | float = ""
    about: Literal["halfway", "mirror"] = "halfway"
    eye: str = "theta_v"  # the value that is the eye's angle; none: it looks straight down
    without: dict[str, str] = field(default_factory=dict)  # kinds of methods that are left out, and why
    cases: tuple[dict[str, Number], ...] = ({},)
    worst: dict[str, tuple[float, ...]] = field(default_factory=dict)
    pixels: str = ""  # the value, a place on the floor, over which the GPU draws the methods' twins as a picture

ModelPlot = Lobes | Slice | ImageSlice
Plot = Curves | Figure | Faces | Ledger | Lobes | Slice | ImageSlice | Study


@dataclass(frozen=True)
class Step:
    name: str
    title: str
    idea: str  # the one sentence to take home
    slides: tuple[str, ...]  # titles of the deck
    prose: str  # Markdown with $...$; a link [words](?tilt=80) sets values, (code:d_beckmann) opens GLSL
    scene: Scene
    plot: Plot | tuple[Plot, ...]
    readouts: tuple[Readout, ...]
    ask: Prediction
    notes: str  # for the lecturer
    sources: tuple[str, ...]
    honesty: str  # what is exact, fitted, approximated, left out
    values: tuple[Value, ...] = ()
    models: tuple[Model, ...] = ()
    minutes: float = 4.0
    beyond: bool = False  # beyond the deck
    studies: tuple[Study, ...] = ()  # of lessons/studies.py
    breaks: tuple[Break, ...] = ()
    leave_outs: tuple[LeaveOut, ...] = ()

    @cached_property
    def plots(self) -> tuple[Plot, ...]:
        """Its plots, each with the models it shows; its studies last."""
        given = self.plot if isinstance(self.plot, tuple) else (self.plot,)
        given += self.studies
        return tuple(replace(plot, models=self.models) if isinstance(plot, ModelPlot) and not plot.models else plot
                     for plot in given)


@dataclass(frozen=True)
class Chapter:
    title: str
    idea: str
    steps: tuple[Step, ...]
    exercises: tuple[Exercise, ...] = ()
    terms: dict[str, str] = field(default_factory=dict)  # glossary, found by the search
