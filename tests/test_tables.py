"""Constant tables of a scene: by name, bound where the scene reads them, exchanged, given back, told by inspection."""

from dataclasses import replace

import numpy as np
import pytest

from app import tables
from app.catalog import step
from app.gpu.evaluate import data_texture, evaluate
from app.gpu.pick import pick
from app.inspection import inspect, words
from app.lesson import Label, Mark, Readout, Surface, Table, Term
from app.problem import Problem, Usage
from app.readouts import numbers
from app.state import defaults
from app.validation import faults
from tests.stage_help import ABOVE, DARK, SQUARE, build, is_alive, picture, watch

SCENE = """
uniform sampler2D grey;
uniform sampler2D depth;
float at(int column, int row) { return texelFetch(grey, ivec2(column, row), 0).x; }
vec3 shade(Surface s) {
    return vec3(at(int(s.st.x * 2.0), int(s.st.y * 2.0)) + 0.0 * texelFetch(depth, ivec2(0), 0).x);
}
vec4 probe(int i) { return vec4(at(0, 0), at(1, 0), at(0, 1), texelFetch(depth, ivec2(0), 0).x); }
vec3 mark_point(int mark, float t) { return vec3(at(1, 1), t, 0.0); }
"""
GREY = np.array([[0.0, 0.2], [0.5, 1.0]])
VALUES = {"grey": GREY, "depth": np.array([[7.0]])}
IES = step("lights/ies")


def scene():
    return build(SQUARE + SCENE, surfaces=(Surface("square", cells=(1, 1)),), labels=(Label("a", 0),),
                 marks=(Mark("m", label="m", label_at=0.0),),
                 tables=(Table("grey", ("bare",)), Table("depth", ("bare",))))


def test_every_part_of_a_scene_reads_its_tables(ctx):
    stage = scene()
    picture(stage, VALUES)
    assert stage.probes(VALUES)[0].tolist() == pytest.approx([0.0, 0.2, 0.5, 7.0])
    assert stage.anchors(VALUES)["m"][0] == 1.0
    found = pick(stage, VALUES, ABOVE, DARK, (0.75, 0.25))  # s.x and s.y above one half: column 1, row 1
    assert found and found.radiance[0] == pytest.approx(1.0)
    stage.release()


def test_a_table_is_sent_once_and_exchanged_and_given_back(ctx, monkeypatch):
    made = watch(monkeypatch)
    stage = scene()
    first = picture(stage, VALUES)
    count = len(made)
    assert (picture(stage, VALUES) == first).all() and len(made) == count
    assert (picture(stage, VALUES | {"grey": 1 - GREY}) != first).any() and len(made) == count + 1
    stage.release()
    assert not any(is_alive(thing) for thing in made if type(thing).__name__ == "Texture")


def test_a_scene_without_its_table_says_so(ctx):
    stage = scene()
    with pytest.raises(Problem, match="the scene needs the table depth"):
        picture(stage, {"grey": GREY})
    stage.release()


def test_a_function_takes_a_table(ctx):
    text = "float cell(sampler2D grey, int index) { return texelFetch(grey, ivec2(index, 1), 0).x; }"
    assert evaluate("cell", {"grey": GREY, "index": [0, 1]}, text).tolist() == [0.5, 1.0]
    with pytest.raises(Problem, match="larger than this OpenGL"):
        data_texture(ctx, np.broadcast_to(0.0, (1, 10**6)))


def test_built_in_tables_by_name():
    assert {"bare", "downlight"} <= set(tables.names())
    with pytest.raises(Usage, match="Did you mean downlight"):
        tables.built_in("downlite")
    own = tables.built_in("flood")
    chosen = tables.chosen(IES.step.scene, {"luminaire": 0})
    assert chosen["table"] is tables.built_in("downlight").table
    assert tables.chosen(IES.step.scene, {"luminaire": 0}, own)["table"] is own.table


def test_inspection_counts_tables_and_says_what_is_left_out():
    found = inspect(IES)
    assert found.tables == {"table": tables.built_in("wall_washer").table.shape} and found.faults == ()
    assert "table       table: 20 x 19 numbers" in words(found)
    other = inspect(step("solid_angle/cone"))
    assert other.tables == {} and "the reader of IES files: the scene has no measured luminaire." in other.left_out
    assert not any("ies" in file for file in other.files)


def test_tables_that_do_not_fit_are_faults():
    idle = replace(IES.step, scene=replace(IES.step.scene, tables=(*IES.step.scene.tables, Table("idle", ("bare",)))))
    told = inspect(replace(IES, step=idle)).faults
    assert any("the table idle is named and not used" in sentence for sentence in told)
    wrong = replace(IES.step, scene=replace(IES.step.scene, tables=(Table("table", ("barre",), "luminaire"),)))
    assert any("there is no luminaire barre" in sentence and "bare" in sentence
               for _, sentence in faults(replace(IES, step=wrong)))


def test_a_number_that_is_not_there_is_said_in_words():
    values = defaults(IES) | {"table": tables.built_in("headlamp").table}
    found = {number.label: number for number in numbers(IES.step, values)}
    assert found["declared"].text == "none: absolute" and found["declared"].error_text == ""
    plain = replace(IES.step, readouts=(Readout("declared", Term("ies_declared"), unit="lm"),))
    assert numbers(plain, values)[0].text == "not a number"
