"""The board: .brdf files are read or refused at their line, computed by their own GLSL, and judged."""

import json
import math

import numpy as np
import pytest

from app.__main__ import main
from app.board.brdf_file import Parameter, parse, read
from app.board.brdf_model import BrdfModel
from app.optics.spherical import direction
from app.problem import Problem

LAMBERT = """\
analytic
# a remark
::begin parameters
float rho 0 1 0.5   # another
color tint 1 .5 .25
bool twice 0
::end parameters
::begin somethingElse
whatever # it is let be
::end somethingElse
::begin shader
const float PI = 3.14159265358979323846;
#define HALF \\
    0.5
#ifdef NEVER
float never() { return nothing; }
#elif 1
float one() { return 1.0; }
#endif
float even(float x) {
#if 1
    return x / PI;
#else
    return nothing;
#endif
}
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    float rho_now = twice ? 2 * rho : rho;
    return one() * tint * (HALF + 0.5) * even(rho_now);
}
::end shader
"""
BLINN = """analytic
::begin parameters
float n 1 1e6 100
bool normalised 0
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    float c = normalised ? (n + 2.) * (n + 4.) / (8. * 3.14159265 * (n + exp2(-.5 * n))) : 1.;
    return vec3(c * pow(max(dot(N, normalize(L + V)), 0.), n));
}
::end shader
"""


def model(text: str) -> BrdfModel:
    return BrdfModel(parse(text, "here.brdf"))


def test_a_file_is_read():
    found = parse(LAMBERT, "a/b/lambert.brdf")
    assert found.name == "lambert"
    assert found.parameters == (Parameter("rho", "float", 0, 1, 0.5, 4),
                                Parameter("tint", "color", 0, 1, (1.0, 0.5, 0.25), 5),
                                Parameter("twice", "bool", 0, 1, False, 6))
    assert found.shader.first == 12


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1", "crlf"])
def test_however_it_is_stored(tmp_path, encoding):
    path, text = tmp_path / "x.brdf", LAMBERT.replace("a remark", "Größe")
    raw = text.replace("\n", "\r\n").encode() if encoding == "crlf" else text.encode(encoding)
    path.write_bytes(raw)
    assert read(path).parameters == parse(LAMBERT, "x").parameters


def changed(old: str, new: str) -> str:
    assert old in LAMBERT
    return LAMBERT.replace(old, new)


@pytest.mark.parametrize(("text", "line", "said"), [
    ("", None, "is empty"),
    ("digital\n", 1, "begins with the word analytic"),
    (changed("::end parameters\n", ""), 7, "inside the block parameters"),
    (changed("::end shader\n", ""), 11, "has no ::end shader"),
    (changed("::end shader", "::end shade"), 31, "ends no open block"),
    (changed("::begin shader", "::begin"), 11, "wants a name"),
    (changed("::begin somethingElse", "words\n::begin somethingElse"), 8, "outside the blocks"),
    (changed("somethingElse", "parameters"), 8, "is there twice"),
    (changed("float rho", "flaot rho"), 4, "there is no type flaot"),
    (changed("float rho 0 1 0.5", "float rho 0 1"), 4, "float name least most default"),
    (changed("0 1 0.5", "0 one 0.5"), 4, "one is no number"),
    (changed("0 1 0.5", "0 nan 0.5"), 4, "nan is no number"),
    (changed("0 1 0.5", "1 0 0.5"), 4, "the least comes first"),
    (changed("bool twice", "bool rho"), 6, "rho is there twice"),
    (changed("bool twice", "bool 2ice"), 6, "no name in GLSL"),
    (changed("vec3 BRDF(", "vec3 brdf("), 12, "defines no vec3 BRDF"),
    (changed("vec3 BRDF(vec3 L", "vec3 BRDF(vec2 L"), 12, "defines no vec3 BRDF"),
    ("analytic\n", None, "no ::begin shader"),
])
def test_a_bad_file_is_refused_at_its_line(text, line, said):
    with pytest.raises(Problem, match=r"^bad\.brdf") as caught:
        parse(text, "bad.brdf")
    assert said in str(caught.value)
    assert line is None or f"line {line}:" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_what_is_no_text_is_refused(tmp_path):
    path = tmp_path / "x.brdf"
    for raw, said in ((b"analytic\0", "not text"), (b"#" * (2 << 20), "megabyte")):
        path.write_bytes(raw)
        with pytest.raises(Problem, match=said):
            read(path)
    with pytest.raises(Problem, match="No such file"):
        read(tmp_path / "none.brdf")


def test_a_compilers_message_is_at_the_users_line_and_in_the_users_words():
    with pytest.raises(Problem, match=r"here\.brdf, line 28: .*rho_new") as caught:
        model(changed("2 * rho : rho", "2 * rho : rho_new")).rgb(*vectors())
    assert "model0_" not in str(caught.value)


def test_what_does_not_link_names_the_file_in_one_sentence():
    text = ("analytic\n::begin shader\nfloat bodiless(float s);\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { "
            "return vec3(bodiless(L.x)); }\n::end shader\n")
    with pytest.raises(Problem, match=r"^here\.brdf: .*does not link.*a function that has no body") as caught:
        model(text).rgb(*vectors())
    assert "\n" not in str(caught.value)


def test_a_default_outside_its_range_is_told():
    found = parse(changed("0 1 0.5", "0 1 2"), "x.brdf")
    assert found.parameters[0].high == 2
    assert "outside 0 to 1" in found.warnings[0]


def vectors():
    return np.array([0.0, 0.0, 1.0]), direction(0.7, 2.0), direction(0.4, 0.0)


def test_its_own_glsl_is_what_is_computed():
    found = model(LAMBERT)
    np.testing.assert_allclose(found.rgb(*vectors()), np.array([1, 0.5, 0.25]) * 0.5 / math.pi, rtol=1e-6)
    np.testing.assert_allclose(found.rgb(*vectors(), {"twice": True, "rho": 0.1})[0], 0.2 / math.pi, rtol=1e-6)


def test_x_and_y_are_across_the_normal():
    text = LAMBERT.replace("return one() * tint", "return vec3(dot(X, N), dot(Y, N), dot(cross(X, Y), N)); return tint")
    np.testing.assert_allclose(model(text).rgb(*vectors()), [0, 0, 1], atol=1e-6)


def test_badges_of_colour_take_the_worst_channel():
    assert model(LAMBERT).badges()["energy"].worst == pytest.approx(0.5, rel=1e-5)
    bright = model(LAMBERT).badges({"tint": (0.1, 0.1, 2.5)})["energy"]
    assert (bright.ok, bright.worst) == (False, pytest.approx(1.25, rel=1e-5))


def test_badges_find_what_is_wrong():
    raw, normalised = model(BLINN).badges({"n": 2.0}), model(BLINN).badges({"n": 100.0, "normalised": True})
    assert not raw["energy"].ok
    assert all(badge.ok for badge in normalised.values())
    assert normalised["energy"].worst == pytest.approx(1, rel=2e-3)  # exact at v = n
    swapped = model(BLINN.replace("dot(N, normalize(L + V))", "dot(N, V) * dot(N, L) * dot(N, L)")).badges({"n": 1.0})
    assert not swapped["reciprocal"].ok
    assert not model(BLINN.replace("vec3(c", "-vec3(c")).badges()["non_negative"].ok
    assert not model(BLINN.replace("vec3(c", "vec3(sqrt(-1. - dot(N, L)) * c")).badges()["finite"].ok


def test_the_command_prints_what_programs_read(tmp_path, capsys):
    path = tmp_path / "blinn.brdf"
    path.write_text(BLINN)
    assert main(["board", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["name"] == "blinn"
    assert found["parameters"][0] == {"name": "n", "type": "float", "min": 1, "max": 1e6, "default": 100}
    assert set(found["badges"]) == {"non_negative", "reciprocal", "energy", "finite"}
    assert set(found["badges"]["energy"]) == {"ok", "worst", "at"}


def test_the_command_knows_the_courses_models(capsys):
    assert main(["board", "lambert", "brdf_lambert", "--json"]) == 0
    first, second = json.loads(capsys.readouterr().out)
    assert first == second
    assert first["badges"]["energy"]["worst"] == pytest.approx(0.8, rel=1e-6)
    assert main(["board", "lambret", "--text"]) == 2
    assert "lambert" in capsys.readouterr().err
