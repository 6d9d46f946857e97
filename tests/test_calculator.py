"""`halfway eval`: right numbers, both backends, strict JSON, and one sentence for every mistake."""

import argparse
import io
import json
import time

import numpy as np
import pytest

from app import optics, shader
from app.calculator import add_arguments, opengl, run
from app.gpu.evaluate import evaluate
from app.problem import Problem, Usage
from app.quantities import TABLE


def ask(*words: str) -> str:
    parser, out = argparse.ArgumentParser(), io.StringIO()
    add_arguments(parser)
    assert run(parser.parse_args(words), out) == 0
    return out.getvalue()


def ask_cases(monkeypatch, text: str) -> list:
    monkeypatch.setattr("sys.stdin", io.StringIO(text))
    return json.loads(ask("--json"), parse_constant=pytest.fail)


def test_degrees_and_lists():
    said = ask("solid_angle_cone", "half_angle=180deg,0.5,30°")
    assert "12.566370614359172" in said
    assert "in sr" in said
    assert len(said.splitlines()) == 5


def test_vectors_and_corners():
    assert "0.339836909454121" in ask("solid_angle_triangle", "a=0,0,1", "b=1,0,1", "c=0,1,1;0,2,1")
    assert "0.80543168316132" in ask("solid_angle_polygon", "corners=-.5,-.5,1;.5,-.5,1;.5,.5,1;-.5,.5,1")


@pytest.mark.parametrize(("backend", "there", "absent"), [("python", "float64", "float32"),
                                                          ("glsl", "float32", "float64")])
def test_one_backend(backend, there, absent):
    said = ask("solid_angle_sphere", "radius=1", "distance=2", "--backend", backend)
    assert there in said
    assert absent not in said


def test_without_opengl_python_answers_alone_and_says_so_once(monkeypatch, capsys):
    def none():
        raise Problem("OpenGL 3.3 could not be started.")

    monkeypatch.setattr("app.gpu.context.context", none)
    opengl.cache_clear()
    try:
        said = ask("solid_angle_cone", "half_angle=180deg")
        assert "12.566370614359172" in said and "GLSL" not in said
        case = '{"function": "solid_angle_cone", "args": {"half_angle": 1}}'
        assert all("value" in a and "glsl" not in a for a in ask_cases(monkeypatch, f"[{case}, {case}]"))
        assert capsys.readouterr().err == "halfway: no float32 answers by GLSL: OpenGL 3.3 could not be started.\n"
        monkeypatch.setattr("app.gpu.evaluate.context", none)
        with pytest.raises(Problem, match="could not be started"):
            ask("solid_angle_cone", "half_angle=180deg", "--backend", "glsl")
    finally:
        opengl.cache_clear()


def test_cases_from_json(monkeypatch):
    octant = [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]]
    cases = [{"function": "solid_angle_cone", "args": {"half_angle": [0.1, "90deg"]}},
             {"function": "direction", "args": {"theta": 0, "phi": 0}},
             {"function": "solid_angle_mesh", "args": {"triangles": octant, "eye": [0, 0, 0]}}]
    answers = ask_cases(monkeypatch, json.dumps(cases))
    assert [{k: a[k] for k in ("function", "args")} for a in answers] == cases
    assert answers[0]["value"] == pytest.approx([0.031389755322206, 2 * np.pi])
    assert answers[1]["glsl"] == [0, 0, 1]
    assert answers[2]["value"] == pytest.approx(np.pi / 2)


def test_no_nan_in_json(monkeypatch):
    answer, = ask_cases(monkeypatch, '[{"function": "cones_in_the_sphere", "args": {"half_angle": [0, 1]}}]')
    assert answer["value"][0] is None
    assert "null" in answer["note"]


@pytest.mark.parametrize(("words", "says"), [
    (("solid_angle_con", "half_angle=1"), "Did you mean solid_angle_cone"),
    (("solid_angle_cone", "half_angel=1"), "Did you mean half_angle"),
    (("solid_angle_sphere", "radius=1"), "needs distance"),
    (("solid_angle_cone", "half_angle=wide"), "'wide' is not a number"),
    (("solid_angle_cone", "half_angle=1e999"), "not finite"),
    (("solid_angle_cone", "half_angle=1,,2"), "'' is not a number"),
    (("solid_angle_cone", "half_angle"), "name=value"),
    (("solid_angle_sphere", "radius=30deg", "distance=1"), "not an angle"),
    (("solid_angle_sphere", "radius=1,2,3", "distance=1,2"), "different numbers"),
    (("solid_angle_cells", "rows=2.5"), "whole number"),
    (("solid_angle_triangle", "a=0,0", "b=1,0,1", "c=0,1,1"), "3 numbers"),
    (("solid_angle_triangle", "a=0,0,1;1,1", "b=1,0,1", "c=0,1,1"), "list of numbers of one shape"),
    (("solid_angle_polygon", "corners=0,0,1", "corner_count=3"), "3 to 8 corners"),
    (("solid_angle_polygon", "corners=" + ";".join(["0,0,1"] * 9)), "3 to 8 corners"),
    (("solid_angle_cone", "half_angle=1", "half_angle=2"), "half_angle is given twice, as 1 and 2"),
    ((), "Name a function"),
])
def test_a_mistake_gets_one_sentence(words, says):
    with pytest.raises(Usage) as caught:
        ask(*words)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("text", ["", "{", "3", "[3]", '[{"function": 3, "args": {}}]',
                                  '[{"function": "solid_angle_cone"}]',
                                  '[{"function": "solid_angle_cone", "args": {"half_angle": null}}]',
                                  '[{"function": "solid_angle_cone", "args": {"half_angle": NaN}}]',
                                  '[{"function": "solid_angle_cone", "args": {"half_angle": {"x": 1}}}]',
                                  '[{"function": "solid_angle_cone", "args": {"half_angle": [[1], [1, 2]]}}]',
                                  '[{"function": "solid_angle_mesh", "args": {"triangles": [], "eye": [0, 0, 0]}}]'])
def test_garbled_cases_are_refused(monkeypatch, text):
    with pytest.raises(Usage):
        ask_cases(monkeypatch, text)


def test_a_mistake_names_its_case(monkeypatch):
    good = '{"function": "solid_angle_cone", "args": {"half_angle": 1}}'
    with pytest.raises(Usage, match=r"^case 1: solid_angle_cone has no argument half_angel"):
        ask_cases(monkeypatch, f"[{good}, {good.replace('half_angle', 'half_angel')}]")


@pytest.mark.parametrize("name", shader.catalogue())
def test_every_twin_can_be_asked(name):
    args = {a: TABLE[a].default for a in optics.arguments(name) if a in TABLE}
    words = [f"{k}={','.join(map(str, v)) if isinstance(v, tuple) else v}" for k, v in args.items()]
    if "corners" in optics.arguments(name):
        words = [w for w in words if not w.startswith("corner_count")] + ["corners=-1,-1,1;1,-1,1;0,1,1"]
    if "table" in optics.arguments(name):
        words.append("table=lessons/ies/downlight.ies")
    if "triangles" not in optics.arguments(name):
        assert name in ask(name, *words)


def test_a_map_is_a_picture_or_the_pattern_made_here(tmp_path):
    from PIL import Image

    Image.new("RGB", (4, 4), (51, 51, 51)).save(tmp_path / "rough.png")
    assert "0.2" in ask("stored_roughness", "map_s=0.3", "map_t=0.4", f"roughness_map={tmp_path / 'rough.png'}",
                        "--backend", "both")
    assert ask("stored_roughness", "map_s=0.3", "map_t=0.4")
    with pytest.raises(Problem, match="no file"):
        ask("stored_roughness", "map_s=0.3", "map_t=0.4", "roughness_map=nowhere.png")


def test_a_million_points_are_quick():
    args = {"half_angle": np.linspace(0, np.pi, 10**6).astype(np.float32)}
    times = []
    for _ in range(4):
        start = time.perf_counter()
        evaluate("solid_angle_cone", args)
        times.append(time.perf_counter() - start)
    assert min(times) < 0.12
