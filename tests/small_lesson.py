"""A chapter of two small steps, written to a folder of its own, for tests that need a lesson they can break."""

from pathlib import Path

from app import catalog

TEXT = '''"""A chapter about little."""

from app.lesson import *

OPEN = Step(
    name="open",
    title="Opening a cone",
    idea="A cone is an angle.",
    slides=("Basic Concepts",),
    prose=r"""
The angle is $\\\\theta$. Make it [wide](?half_angle=90), or read [the other](small/shape?shape=1).
""",
    scene=Scene(
        glsl="""
uniform float half_angle;
uniform int samples;

vec3 mark_point(int mark, float t) {
    return vec3(t * sin(half_angle), float(samples), 0.0);
}

vec4 probe(int i) {
    return vec4(half_angle);
}
""",
        marks=(Mark("ray"),),
        handles=(Handle("the rim", 0, ("half_angle",)),),
    ),
    plot=Curves("Cone", "half_angle", (Curve("cone", Term("solid_angle_cone")),), "sr"),
    readouts=(Readout("cone", Term("solid_angle_cone"), role="exact"),),
    ask=Prediction("How much is half of everything?", Term("solid_angle_cone"), "sr", "2 pi.", 0.0, 10.0,
                   sets={"half_angle": 90.0}),
    notes="Say little.",
    sources=("nobody",),
    honesty="Exact.",
    values=(Value("half_angle", 30.0, low=0.0, high=120.0), Value("corner_a", (0.3, 0.2), more=True)),
)

SHAPE = Step(
    name="shape",
    title="Café of shapes",
    idea="A mesh is many triangles.",
    slides=("Solid Angles",),
    prose="Nothing to say.",
    scene=Scene(
        glsl="""
uniform vec3 eye;

vec3 mesh_point(int surface, vec3 p) {
    return p - eye;
}

vec3 shade(Surface s) {
    return s.normal;
}
""",
        surfaces=(Surface("mesh", mesh=True),),
        meshes=("cube", "bowl"),
    ),
    plot=Faces("faces"),
    readouts=(Readout("all", Term("solid_angle_mesh")),),
    ask=Prediction("Which?", Term("solid_angle_cone", {"half_angle": 1.0}), "sr", "That one.",
                   choices=(Choice("little", 0.0, 1.0), Choice("more", 1.0, 5.0))),
    notes="Say less.",
    sources=("nobody",),
    honesty="Exact.",
)

CHAPTER = Chapter("Small", "Little is enough.", (OPEN, SHAPE), terms={"radian": "an arc over its radius"})
'''


def write(folder: Path, *changes: tuple[str, str], name: str = "ch01_small.py") -> Path:
    """The lesson with some of its text replaced, in folder/lessons; returns that folder."""
    text = TEXT.replace("\\\\", "\\")
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    lessons = folder / "lessons"
    lessons.mkdir(exist_ok=True)
    (lessons / name).write_text(text, encoding="utf-8")
    catalog.forget()
    return lessons


def model_lesson(folder: Path) -> Path:
    """The lesson with two models and two plots in its first step."""
    curves = 'Curves("Cone", "half_angle", (Curve("cone", Term("solid_angle_cone")),), "sr")'
    models = '''    models=(
        Model("printed", Term("shading_phong"), "printed"), Model("Phong", Term("brdf_phong"), "d")),
    values=(Value("theta_l", 40.0), Value("theta_v", 30.0), Value("phi", 180.0, low=0.0), Value("exponent", 40.0),
            Value("half_angle"'''
    return write(folder, ('    values=(Value("half_angle"', models),
                 (f"    plot={curves},", f'    plot=(Lobes("Two lobes"),\n          {curves}),'))


def line(lessons: Path, words: str, name: str = "ch01_small.py") -> int:
    """The number of the first line with these words."""
    lines = (lessons / name).read_text(encoding="utf-8").splitlines()
    return next(i for i, text in enumerate(lines, 1) if words in text)
