"""The GLSL a student reads on the desktop is the GLSL a browser runs: every text under the header of the web."""

import os
from functools import cache

import moderngl
import pytest

from app import catalog, shader
from app.everything import shading
from app.gpu.evaluate import point_program
from app.gpu.stage_text import PARTS, needed, programs
from app.paths import GLSL
from lessons.cover import COVER
from tests.browser import CHROMIUM, chromium

EMPTY = shader.WEB[0] + "\nprecision highp float;\nvoid main() {}\n"
LINK = """
texts => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return ["no WebGL2"];
    return texts.map(([name, vertex, fragment]) => {
        const program = gl.createProgram(), said = [];
        for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
            const one = gl.createShader(type);
            gl.shaderSource(one, text);
            gl.compileShader(one);
            gl.attachShader(program, one);
            said.push(gl.getShaderInfoLog(one));
        }
        gl.linkProgram(program);
        const linked = gl.getProgramParameter(program, gl.LINK_STATUS);
        gl.deleteProgram(program);
        return linked ? "" : name + ": " + said.join(" ") + gl.getProgramInfoLog(program);
    }).filter(words => words);
}
"""


@cache
def texts() -> dict[str, tuple[shader.Assembled, shader.Assembled | None]]:
    """Every program of every scene, and for every function of glsl/optics the program that calls it."""
    found = {}
    for step in catalog.steps():
        drawn = needed(step.step.scene)
        names = (*drawn, *(f"{name} values" for name in drawn if f"{name} values" in PARTS))
        for name, pair in programs(step.step.scene, step.file_name, step.glsl_line, shader.WEB, names).items():
            found[f"{step.id}: {name}"] = pair
    for name, pair in programs(COVER, "lessons/cover.py", header=shader.WEB).items():
        found[f"cover: {name}"] = pair
    for name, (include, signature) in shader.catalogue().items():
        source = point_program(signature, include, None)[0]
        found[f"{include}: {name}"] = shader.assemble(source, name, header=shader.WEB), None
    for name, pair in programs(catalog.step("board/cook_torrance").step.scene, header=shader.WEB).items():
        found[f"a board: {name}"] = pair
    for file in ("display/lobe.glsl", "display/merl.glsl"):  # for scenes with lobes, and measured matter
        for name, signature in shader.signatures(shader.read(file)).items():
            source = point_program(signature, file, None)[0]
            found[f"{file}: {name}"] = shader.assemble(source, name, header=shader.WEB), None
    cone = programs(catalog.step("solid_angle/cone").step.scene, header=shader.WEB)["surface"][0]
    typed = (("scene", shader.Source(catalog.step("solid_angle/cone").step.scene.glsl.replace(
        "shade(Surface s) {", "shade(Surface s) {\n    while (s.id > 9) s.id--;", 1), "yours", is_own=True)),)
    for name, pair in programs(catalog.step("solid_angle/cone").step.scene, header=shader.WEB, overrides=typed,
                               watched=True).items():
        found[f"a loop of a user's: {name}"] = pair
    found["everything on"] = cone, shading(shader.WEB)
    return found


def test_every_glsl_file_is_among_them():
    """No file is left out of the two tests below: each gives something to some program."""
    used = {line.file for pair in texts().values() for text in pair if text for line in text.lines if line.text.strip()}
    files = {f"glsl/{path.relative_to(GLSL).as_posix()}" for path in GLSL.rglob("*.*")}
    assert files - used == set()


@pytest.mark.parametrize("name", texts())
def test_mesa_compiles_it_as_es(name, ctx):
    vertex, fragment = texts()[name]
    with ctx:
        try:
            made = ctx.program(vertex_shader=vertex.text, fragment_shader=fragment.text if fragment else EMPTY)
        except moderngl.Error as error:
            of_fragment = "fragment_shader" in str(error) and fragment
            pytest.fail(shader.translate(str(error), fragment if of_fragment else vertex))
        made.release()


def in_browser(pairs: list[tuple[str, str, str]]) -> list[str]:
    with chromium() as browser:
        return browser.new_page().evaluate(LINK, pairs)


@pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium, which only CI installs")
def test_chromium_links_them_all():
    assert CHROMIUM, "CI must have Chromium"
    pairs = [(name, vertex.text, fragment.text if fragment else EMPTY) for name, (vertex, fragment) in texts().items()]
    bad = "void main() { gl_Position = vec4(0.5 * 2); }"
    pairs.append(("a text for the desktop only", shader.WEB[0] + "\nprecision highp float;\n" + bad, EMPTY))
    found = in_browser(pairs)
    assert len(found) == 1 and found[0].startswith("a text for the desktop only: ERROR"), found
