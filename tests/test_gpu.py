"""The context, and GLSL functions as array functions: shapes, types, and what is said when they do not fit."""

import subprocess
import sys
from textwrap import dedent

import numpy as np
import pytest

from app import optics
from app.gpu.evaluate import MAX_CORNERS, evaluate
from app.paths import ROOT
from app.problem import Problem, Usage
from app.stress.domain import cube
from tests.stage_help import is_alive, watch

TEXT = """
float twice(float x) { return 2.0 * x; }
int halved(int n) { return n / 2; }
vec2 turned(vec2 p, float by) { return by * vec2(-p.y, p.x); }
vec4 all_of_it(vec3 p, int n, float w) { return vec4(p * w, float(n)); }
float total(float weights[8], int n) {
    float sum = 0.0;
    for (int i = 0; i < n; i++) sum += weights[i];
    return sum;
}
float first_only(float a, float b) { return a; }
void nothing(float x) { }
bool yes(float x) { return x > 0.0; }
"""


def own(function: str, **args):
    return evaluate(function, args, TEXT)


def test_shapes_are_broadcast():
    x, y = np.linspace(1, 2, 4), np.linspace(3, 4, 3)[:, None]
    got = evaluate("solid_angle_rectangle", {"width": x, "depth": y, "distance": 2.0})
    assert got.shape == (3, 4) and got.dtype == np.float32
    np.testing.assert_allclose(got, optics.twin("solid_angle_rectangle")(x, y, 2.0), rtol=1e-6)
    assert own("twice", x=3.0).shape == () and own("twice", x=3.0) == 6.0


def test_vectors_in_and_out():
    theta = np.linspace(0, 3, 10).reshape(2, 5)
    assert evaluate("direction", {"theta": theta, "phi": 0.5}).shape == (2, 5, 3)
    assert own("turned", p=np.ones((4, 2)), by=np.arange(3.0)[:, None]).shape == (3, 4, 2)
    np.testing.assert_array_equal(own("turned", p=(1.0, 2.0), by=3.0), [-6.0, 3.0])
    np.testing.assert_array_equal(own("all_of_it", p=(1, 2, 3), n=7, w=2), [2, 4, 6, 7])


def test_integers_stay_whole():
    big = np.array([5, 16_777_217, -7, 2_147_483_647])
    got = own("halved", n=big)
    assert got.dtype == np.int32 and got.tolist() == [2, 8_388_608, -3, 1_073_741_823]


def test_arrays_of_corners_and_numbers():
    square = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1.0]])
    got = evaluate("solid_angle_polygon", {"corners": square, "corner_count": [3, 4]})
    np.testing.assert_allclose(got, [np.pi / 3, 2 * np.pi / 3], rtol=1e-6)
    assert own("total", weights=[1.0, 2.0, 4.0], n=[1, 2, 3, 5]).tolist() == [1, 3, 7, 7]


def test_meshes_go_in_as_textures():
    for faces in (cube(), np.tile(cube(), (30, 1, 1))):  # one row of the texture, and two
        got = evaluate("solid_angle_mesh", {"triangles": faces, "eye": [(0.0, 0.0, 0.0), (3.0, 0.5, 0.2)]})
        np.testing.assert_allclose(got, [len(faces) / 12 * 4 * np.pi, 0.0], atol=2e-4)


def test_nothing_in_nothing_out():
    assert evaluate("solid_angle_cone", {"half_angle": np.empty((0, 3))}).shape == (0, 3)
    assert evaluate("direction", {"theta": np.empty(0), "phi": 1.0}).shape == (0, 3)


def test_an_argument_nobody_reads_does_no_harm():
    assert own("first_only", a=[1.0, 2.0], b=[[1.0], [2.0], [3.0]]).shape == (3, 2)


def test_nan_and_inf_come_through():
    got = own("twice", x=[np.nan, np.inf, -np.inf, 3e38])
    assert np.isnan(got[0]) and got[1:].tolist() == [np.inf, -np.inf, np.inf]


def test_twice_the_same_is_the_same_bits():
    args = {"distance": np.geomspace(0.1, 9, 5000), "tilt": 0.3, "width": 0.7}
    np.testing.assert_array_equal(evaluate("solid_angle_patch", args), evaluate("solid_angle_patch", args))


REFUSED = {
    "an unknown function": ("solid_angle_kone", {}, None, "solid_angle_kone. Did you mean solid_angle_cone"),
    "an unknown own function": ("twise", {}, TEXT, "no GLSL function twise. Did you mean twice"),
    "a missing argument": ("solid_angle_cone", {"angle": 1.0}, None, "solid_angle_cone needs half_angle"),
    "shapes that do not fit": ("first_only", {"a": [1, 2], "b": [1, 2, 3]}, TEXT, r"a \(2,\), b \(3,\)"),
    "a vector too short": ("all_of_it", {"p": (1, 2), "n": 1, "w": 1}, TEXT, "p is a vec3, its last axis has 3"),
    "a number for a vector": ("all_of_it", {"p": 1.0, "n": 1, "w": 1}, TEXT, "p is a vec3"),
    "one outline a point": ("solid_angle_polygon", {"corners": np.ones((2, 4, 3)), "corner_count": 4}, None,
                            "corners is one array"),
    "a mesh that is none": ("solid_angle_mesh", {"triangles": np.ones((4, 3)), "eye": (0, 0, 0)}, None,
                            r"triangles is one array of shape \('n', 3, 3\)"),
    "a table that is none": ("ies_flux", {"table": np.ones(7)}, None, "table is one table of rows and columns"),
    "nothing returned": ("nothing", {"x": 1.0}, TEXT, "has the type void"),
    "a truth value": ("yes", {"x": 1.0}, TEXT, "has the type bool"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_does_not_fit_is_said(case):
    function, args, text, words = REFUSED[case]
    with pytest.raises(Usage, match=words):
        evaluate(function, args, text)


def test_too_many_corners():
    with pytest.raises(Problem, match=f"9 corners; the GLSL side takes at most {MAX_CORNERS}"):
        evaluate("solid_angle_polygon", {"corners": np.ones((9, 3)), "corner_count": 9})


def test_a_mistake_is_named_with_its_line():
    text = "// mine\nfloat f(float x) {\n    return x * y;\n}"
    with pytest.raises(Problem, match=r"f, line 3: .*`?y'? undeclared"):
        evaluate("f", {"x": 1.0}, text)
    assert own("twice", x=1.0) == 2.0, "and the next call is well again"


def test_nothing_is_left_behind(ctx, monkeypatch):
    made = watch(monkeypatch)
    args = {"triangles": cube(), "eye": np.zeros((5, 3))}
    evaluate("solid_angle_mesh", args, ctx=ctx)
    evaluate("solid_angle_polygon", {"corners": np.ones((4, 3)), "corner_count": [3, 4]}, ctx=ctx)
    assert len(made) >= 7 and not [thing for thing in made if is_alive(thing)]


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", dedent(code)], capture_output=True, text=True, timeout=120,
                          check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def test_the_context_is_safe_beside_vtk():
    """VTK opens, draws and closes in the same process: it takes the current context and ends the display it shares."""
    assert run("""
        import os
        os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkEGLRenderWindow"
        import numpy as np
        from app.gpu.context import context
        from app.gpu.evaluate import evaluate
        args = {"half_angle": np.linspace(0, 3, 1000)}
        before = evaluate("solid_angle_cone", args)
        import pyvista
        for _ in range(2):
            plotter = pyvista.Plotter(off_screen=True, window_size=(64, 64))
            plotter.add_mesh(pyvista.Sphere())
            picture = plotter.screenshot(return_img=True)
            assert np.array_equal(evaluate("solid_angle_cone", args), before), "while VTK's window is open"
            again = plotter.screenshot(return_img=True)
            assert picture.std() > 1 and np.array_equal(picture, again), "and VTK's own picture"
            plotter.close()
            assert np.array_equal(evaluate("solid_angle_cone", args), before), "after it is closed"
        with context() as now:
            assert (now or context()).error == "GL_NO_ERROR"
        print("well")
    """).strip().endswith("well")


def test_one_context_and_programs_by_their_text(ctx):
    from app.gpu.context import context, kept
    assert context() is ctx
    evaluate("solid_angle_cone", {"half_angle": 1.0}, ctx=ctx)
    count = len(kept(ctx))
    evaluate("solid_angle_cone", {"half_angle": [1.0, 2.0]}, ctx=ctx)
    assert len(kept(ctx)) == count


def test_evaluating_needs_neither_vtk_nor_a_window():
    loaded = run("""
        import sys
        from app.gpu.evaluate import evaluate
        evaluate("solid_angle_cone", {"half_angle": 1.0})
        print(*{"vtk", "vtkmodules", "pyvista", "imgui_bundle", "trimesh", "pyrender", "PIL"} & set(sys.modules))
    """)
    assert loaded.strip() == ""


@pytest.mark.parametrize(("given", "found"), [(None, "nopt"), ("", ""), ("no_aos_sampling", "no_aos_sampling")])
def test_mesa_is_asked_to_compile_quickly_unless_told_otherwise(given, found, monkeypatch):
    monkeypatch.delenv("GALLIVM_PERF", raising=False)
    if given is not None:
        monkeypatch.setenv("GALLIVM_PERF", given)
    code = "import os, app; print(os.environ['GALLIVM_PERF'])"
    assert subprocess.check_output([sys.executable, "-c", code], text=True, cwd=ROOT).rstrip("\n") == found
