"""An unknown folder of `.brdf` files: each gets its verdict, or one sentence at its line; nothing crashes."""

import json
import warnings
from pathlib import Path

import pytest

from app import edit
from app.__main__ import main
from app.board import board_step
from app.board.brdf_file import read
from app.board.models import opened
from app.catalog import step
from app.export.still import data
from app.gpu.stage import Stage
from app.gpu.watch import watch
from app.problem import Problem
from app.state import defaults
from app.theme import THEMES
from tests.window import drive, until

HEAD = "analytic\n"
BODY = "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {{ return vec3({}); }}"


def parameters(*lines: str) -> str:
    return "\n".join(["::begin parameters", *lines, "::end parameters\n"])


def shader(value: str = "0.3", before: str = "") -> str:
    return f"::begin shader\n{before}{BODY.format(value)}\n::end shader\n"


K = HEAD + parameters("float k 0 1 .5") + shader("0.3 * k")
GOOD = {  # name -> (text, its directional albedo over pi)
    "every kind of block.brdf": (HEAD + "::begin isFunc\nx { ( ;\n::end isFunc\n" + parameters(
        "float k 0 1 .5", "bool on 1", "color c .3 .2 .1") + shader("on ? k * c : c")
        + "::begin importance\nfloat pdf() { return 1.; }\n::end importance\n", 0.15),
    "lines end as in Windows.brdf": (K.replace("\n", "\r\n"), 0.15),
    "lines end as in old days.brdf": (K.replace("\n", "\r"), 0.15),
    "a mark at its front.brdf": ("\ufeff" + K, 0.15),
    "tabs.brdf": ("\t" + K.replace("\n", "\n\t").replace(" ", "\t"), 0.15),
    "ünï çödé 反射.brdf": (K.replace(".5", ".5 # Größe 粗さ").replace("shader\n", "shader\n// 粗さ\n", 1), 0.15),
    "quote'\"&?+#%.brdf": (K, 0.15),
    "-dash.brdf": (K, 0.15),
    "defaults out of range.brdf": (HEAD + parameters("float k 0 1 7", "float j 1 2 -3") + shader("0.01 * k"), 0.07),
    "colours out of range.brdf": (HEAD + parameters("color c 2 -1 0.5") + shader("0.1 * abs(c)"), 0.2),
    "bools are numbers.brdf": (HEAD + parameters("bool a 0", "bool b 1", "bool c 2") + shader("!a && b && c ? .2 : .1"),
                               0.2),
    "globals.brdf": (HEAD + parameters("float k 0 1 .5") + shader(
        "twice(0.2)", "const float two = 2.0;\nfloat scale;\n"
        "float twice(float x) { scale = x; return two * scale * k; }\n"), 0.2),
    "conditions.brdf": (HEAD + parameters("float k 0 1 .5") + shader(
        "0.2 * f()", "#define SQR(x) ((x) * (x))\n#ifdef NOPE\nthis is no code\n#else\n#if __VERSION__ >= 120\n"
        "float f() { return 4.0 * SQR(k); }\n#endif\n#endif\n"), 0.2),
    "old GLSL.brdf": (HEAD + shader("0.3", "uniform samplerCube envmap;\nvarying vec3 way;\n"), 0.3),
    "names of the stage.brdf": (HEAD + parameters("float values 0 1 .5", "float n 0 1 .5",
                                                   "float model0_k 0 1 .5") + shader(
        "shade(values * n * model0_k)", "float shade(float x) { return x; }\n"), 0.125),
    "names of GLSL.brdf": (HEAD + parameters("float pow 0 1 .2", "float PI 0 4 3.14") + shader("pow"), 0.2),
    "a head of many lines.brdf": (HEAD + "::begin shader\n  vec3\n  BRDF( in vec3 toLight,\n  in vec3 b, in vec3 c,\n  "
                                  "in vec3 d, in vec3 e )\n{\n  return vec3(0.3);\n}\n::end shader\n", 0.3),
    "sixty parameters.brdf": (HEAD + parameters(*(f"float k{i} 0 1 .5" for i in range(60))) + shader("0.1 * k9"), 0.05),
    "a main of its own.brdf": (HEAD + shader("0.3", "void main() { gl_FragColor = vec4(1.); }\n"), 0.3),
    "a range of one value.brdf": (HEAD + parameters("float k .5 .5 .5") + shader("0.3 * k"), 0.15),
    "a remark with a head.brdf": (HEAD + shader("0.3", "/* vec3 BRDF( ::begin x */\n"), 0.3),
}
TOLD = {  # name -> (text, what is said of it)
    "no end.brdf": (HEAD + parameters("float k 0 1 .5") + "::begin shader\n", "line 5: the block shader has no ::end"),
    "no begin.brdf": (HEAD + BODY + "\n::end shader\n", "line 2: .* stands outside the blocks"),
    "twice.brdf": (HEAD + parameters("float k 0 1 .5", "float k 0 2 1") + shader(), "line 4: k is there twice; line 3"),
    "words for numbers.brdf": (HEAD + parameters("bool a true") + shader(), "line 3: true is no number"),
    "limits of a colour.brdf": (HEAD + parameters("color c 0 1 .5 .5 .5") + shader(), "line 3: .*color name r g b"),
    "a whole number.brdf": (HEAD + parameters("int k 0 4 2") + shader(), "line 3: there is no type int"),
    "a keyword.brdf": (HEAD + parameters("float float 0 1 .5") + shader(), "line 3: float can be no name in GLSL"),
    "größe.brdf": (HEAD + parameters("float größe 0 1 .5") + shader("größe"), "line 3: größe can be no name in GLSL"),
    "a function's name.brdf": (HEAD + parameters("float BRDF 0 1 .5") + shader(), "line 3: BRDF is a function of its"),
    "include.brdf": (HEAD + shader("0.3", '# include "x.glsl"\n'), "line 3: .*a .brdf file stands alone"),
    "version.brdf": (HEAD + shader("0.3", "#version 120\n"), "line 3: .*it is read as GLSL 3.30"),
    "extension.brdf": (HEAD + shader("0.3", "#extension GL_X : enable\n"), "line 3: .*it is read as GLSL 3.30"),
    "remarks as outside.brdf": (HEAD + shader("0.3", "# a remark\n"), "line 3: .*#"),
    "recursion.brdf": (HEAD + shader("g(L.z)", "float g(float x) { return g(x); }\n"), "line 3: g calls itself"),
    "endless.brdf": (HEAD + shader("g(L.z)", "float g(float x) { for (;;) ; return x; }\n"), "line 3: this loop never"),
    "a pixel's words.brdf": (HEAD + shader("dFdx(L.x)"), "line 3: .*dFdx"),
    "nothing.brdf": ("", "is empty"), "bytes.brdf": ("\0\1", "is not text"),
    "merl.brdf": ("merl\n", "line 1: .*analytic"),
}


@pytest.fixture
def folder(tmp_path) -> Path:
    for name, (text, _) in (GOOD | TOLD).items():
        (tmp_path / name).write_bytes(text.encode())
    return tmp_path


def test_a_folder_is_judged_file_by_file(folder, capsys):
    assert main(["board", str(folder), "--json"]) == 0
    out, said = capsys.readouterr()
    found = {one["name"]: one["badges"] for one in json.loads(out)}
    assert set(found) == {Path(name).stem for name in GOOD}
    for name, (_, albedo) in GOOD.items():
        energy = found[Path(name).stem]["energy"]
        assert energy["worst"] == pytest.approx(3.14159265 * albedo, rel=1e-4) and energy["ok"], name
    for name in TOLD:
        assert name in said
    assert "Traceback" not in said and "value_of_model" not in said and "Warning" not in said


@pytest.mark.parametrize("name", TOLD)
def test_what_is_wrong_is_told_at_its_line(folder, name):
    with pytest.raises(Problem, match=TOLD[name][1]) as caught:
        opened(str(folder / name)).badges()
    assert str(caught.value).startswith(str(folder / name))


@pytest.mark.parametrize("name", GOOD)
def test_each_is_drawn_on_the_board(folder, ctx, name):
    """The scene's text is another than that of the numbers: names of either must not meet."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = step(board_step.id_of([str(folder / name)]))
    values = defaults(found) | data(found, defaults(found))
    stage = Stage(ctx, edit.source_of(found), values["triangles"], values)
    watch(stage, values, found.step.scene.camera)
    stage.draw(values, found.step.scene.camera, (64, 48), THEMES["dark"], fine=False)
    assert not stage.picture.faults() and edit.functions(found)
    assert read(folder / name).defaults.keys() == {p.name for p in found.shown[0].model.parameters}
    stage.release()


def test_dropped_one_after_the_other_the_window_goes_on(folder, monkeypatch):
    """Good ones come upon the board, of the others a sentence: as long as the board is there, on its list."""
    monkeypatch.setenv("HALFWAY_DATA", str(folder / "data"))
    good, told = list(GOOD)[::7], list(TOLD)[::5]

    def test(engine, window):
        until(engine, window, lambda: window.frame > 3)
        for name in (told[0], *good, *told):
            window.dropped.append(str(folder / name))
            until(engine, window, lambda: not window.dropped)
            until(engine, window, lambda: window.scene.is_fine)
            assert not window.own.no_picture
            assert (name in told) == (name in window.message)
        entries = {Path(one.word).name: one for one in window.session.current.entries}
        assert set(entries) == {*good, *told}
        assert all(bool(entries[name].fault) == (name in told) for name in entries)

    drive(test)
