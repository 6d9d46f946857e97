"""Choices that are decided when a program is compiled: the same picture, no uniform, a compilation for each flip."""

from dataclasses import replace

import moderngl
import numpy as np
import pytest

from app import edit
from app.catalog import step, steps, values_of
from app.export.still import data
from app.export.web.content import content
from app.gpu.pick import raw
from app.gpu.scene_programs import KEPT
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.inspect_all import Row, summary
from app.inspection import inspect
from app.inspection import words as inspected
from app.lesson import Value
from app.maps import OwnMap
from app.problem import Problem
from app.state import defaults
from app.theme import THEMES
from app.validation import faults

DECIDED = [found for found in steps() if found.step.scene.decided]
WORK, UNITS = step("lights/area_work"), step("lights/area_units")
SIZE, DARK = (96, 72), THEMES["dark"]


def whole(found) -> dict:
    values = defaults(found)
    return values | data(found, values)


def on_stage(found, values, ctx, **changes) -> Stage:
    scene = replace(found.step.scene, **changes)
    return Stage(ctx, Source(scene, found.file_name, found.glsl_line), values.get("triangles"), values)


def editable(found, ctx) -> tuple[Stage, dict, Source, dict]:
    """A stage of it with what is needed to edit it: its functions, its source, its values."""
    values, source = whole(found) | found.derived(defaults(found)), edit.source_of(found)
    return Stage(ctx, source, values.get("triangles"), values), edit.functions(found), source, values


def picture(stage, values) -> np.ndarray:
    stage.draw(values, stage.scene.camera, SIZE, DARK, fine=False)
    assert not stage.picture.faults()
    return stage.picture.pixels().astype(int)


@pytest.fixture
def compiled(monkeypatch, ctx) -> list[str]:
    """The texts that are handed to OpenGL from now on; nothing is taken from earlier."""
    texts: list[str] = []
    real = moderngl.Context.program

    def watched(self, *, vertex_shader, fragment_shader=None, **more):
        texts.append(vertex_shader + (fragment_shader or ""))
        return real(self, vertex_shader=vertex_shader, fragment_shader=fragment_shader, **more)

    monkeypatch.setattr(moderngl.Context, "program", watched)
    monkeypatch.setattr(ctx, "extra", {})
    return texts


def test_some_steps_decide():
    assert {"lights/area_sampled", "lights/area_work", "plausible_shading/board"} <= {found.id for found in DECIDED}


@pytest.mark.parametrize("found", DECIDED, ids=lambda found: found.id)
def test_the_picture_is_the_same_for_every_choice(found, ctx):
    values = whole(found)
    asked, ready = on_stage(found, values, ctx, decided=()), on_stage(found, values, ctx)
    seen = []
    for name in found.step.scene.decided:
        for number in range(len(found.values[name].choices) if name in found.values else 0):
            now = values | {name: number}
            seen.append(picture(ready, now))
            assert np.abs(seen[-1] - picture(asked, now)).max() <= 1, (name, number)
            assert np.allclose(ready.probes(now), asked.probes(now), atol=1e-5)
    for table in found.step.scene.tables:
        texels = np.random.default_rng(3).integers(100, 256, (8, 8, 4)).astype(np.uint8)
        texels[..., 3] = 255
        now = values | {table.uniform: OwnMap(table.map, "my own", texels, "").texels}
        seen.append(picture(ready, now))
        assert np.abs(seen[-1] - picture(asked, now)).max() <= 1, table.map
        assert np.abs(seen[-1] - picture(ready, values)).max() > 20, "the map is seen"
    assert max(np.abs(one - seen[0]).max() for one in seen[1:]) > 20, "a choice is seen"
    asked.release()
    ready.release()


def test_a_flip_compiles_what_has_changed_and_its_way_back_nothing(ctx, compiled):
    values = whole(WORK)
    stage = on_stage(WORK, values, ctx)
    first = len(compiled)
    picture(stage, values)
    assert len(compiled) == first == len(stage.programs), "its programs, and each once"
    for name in ("light_shape", "sampling"):
        assert not any(f"uniform int {name};" in text for text in compiled)
    assert sum("const int sampling = 2;" in text for text in compiled) == 2, "the floor's and the dots'"
    flipped = values | {"sampling": 5}
    picture(stage, flipped)
    assert len(compiled) == first + 2
    for now in (values, flipped, values | {"level": 3}):
        picture(stage, now)
    assert len(compiled) == first + 2
    stage.release()


def test_few_choices_are_kept_and_others_released(ctx, compiled):
    values = whole(UNITS)
    stage = on_stage(UNITS, values, ctx)
    scene_programs = dict(stage.programs)
    for number in (1, 2, 3, 0, 1, 2, 3):
        picture(stage, values | {"light_shape": number})
    assert len(stage.own.others) == 3 <= KEPT
    own = list(stage.own.passing.values())
    stage.own.others.clear()
    stage.own.let_go()
    assert sum(type(use.mglo).__name__ == "InvalidObject" for use in own) > 3
    assert picture(stage, values).std() > 5 and dict(stage.programs) == scene_programs
    stage.release()


def test_the_values_of_the_first_picture_are_decided_at_once(ctx, compiled):
    values = whole(WORK) | {"sampling": 4, "light_shape": 3}
    stage = on_stage(WORK, values, ctx)
    first = len(compiled)
    picture(stage, values)
    assert len(compiled) == first and any("const int sampling = 4;" in text for text in compiled)
    stage.release()


def test_a_text_that_is_edited_is_right_for_every_choice(ctx, compiled):
    known, source, values = edit.functions(WORK), edit.source_of(WORK), whole(WORK)
    stage = Stage(ctx, source, None, values)
    text = known["sample_share"].text.replace("to_sample.z /", "2.0 * to_sample.z /")
    before = picture(stage, values)
    stage.rewrite(edit.overrides({"sample_share": text}, known, source))
    edited = picture(stage, values)
    assert np.abs(edited - before).max() > 20
    plain, now = on_stage(WORK, values, ctx, decided=()), values | {"light_shape": 1}
    plain.rewrite(edit.overrides({"sample_share": text}, known, source))
    assert np.abs(picture(stage, now) - edited).max() > 20
    assert np.abs(picture(stage, now) - picture(plain, now)).max() <= 1
    stage.rewrite(())
    plain.rewrite(())
    assert np.abs(picture(stage, now) - picture(plain, now)).max() <= 1
    stage.release()
    plain.release()


def test_a_mistake_is_told_where_it_is_not_chosen_now_too(ctx):
    known, source, values = edit.functions(WORK), edit.source_of(WORK), whole(WORK)
    stage = Stage(ctx, source, None, values)
    text = known["shade"].text.replace("{", "{ if (light_shape == 3) return vec3(mistaken);", 1)
    with pytest.raises(Problem, match=r"^your shade, line 1: .*mistaken"):
        stage.rewrite(edit.overrides({"shade": text}, known, source))
    stage.release()


@pytest.mark.parametrize(("id", "name", "programs"), [
    ("lights/area_work", "sample_share", 1),
    ("microfacets/cook_torrance", "d_beckmann", 1), ("microfacets/cook_torrance", "shade", 1),
    ("plausible_shading/everything", "d_beckmann", 1),  # a vase, which is a grid, and a mesh in one
    ("plausible_shading/board", "d_beckmann", 1),
    ("board/cook_torrance", "d_beckmann", 2),  # its ball; its lobes, one of them to look through
    ("board/cook_torrance+oren_nayar+phong", "d_beckmann", 2),  # nothing of the other two
    ("board/cook_torrance+oren_nayar+phong", "reflected", 2),  # balls at their pixels, lobes at their corners
])
def test_an_edit_compiles_what_holds_it_and_no_more(ctx, compiled, id, name, programs):
    """And a program of the text alone, for mistakes where it is not run."""
    stage, known, source, values = editable(step(id), ctx)
    picture(stage, values)
    stage.rewrite(edit.overrides({name: known[name].text.replace("{", "{ float first = 0.0;", 1)}, known, source))
    del compiled[:]
    stage.rewrite(edit.overrides({name: known[name].text.replace("{", "{ float second = 0.0;", 1)}, known, source))
    picture(stage, values)
    assert len(compiled) == 1 + programs and all("float second" in text for text in compiled)
    stage.release()


def test_of_a_typed_text_every_choice_is_a_constant_and_the_picture_follows_each(ctx, compiled):
    """The same pictures as from programs that ask; what is not shown is not compiled."""
    found = step("board/cook_torrance+phong")
    stage, known, source, values = editable(found, ctx)
    plain = Stage(ctx, replace(source, choices=()), values["triangles"], values)
    assert {"shows", "stands", "model", "board_channel"} <= set(stage.own.seen) and not plain.own.seen
    text = known["d_beckmann"].text.replace("{", "{ m *= 1.5;", 1)
    for one in (plain, stage):
        del compiled[:]
        one.rewrite(edit.overrides({"d_beckmann": text}, known, source))
    assert not any("uniform int shows;" in one for one in compiled[1:]) and "mesh 2" not in stage.programs
    seen = []
    for now in ({}, {"stands": 1}, {"shows": 9}, {"model": 1}, {"lobe_scale": 2}, {}):
        seen.append(picture(stage, values | now))
        assert np.abs(seen[-1] - picture(plain, values | now)).max() <= 1, now
    assert np.array_equal(seen[0], seen[-1]) and all(np.abs(one - seen[0]).max() > 20 for one in seen[1:-1])
    assert {"mesh 2", "mesh 3"} & stage.programs.keys() == set(), "at the end it stands no more"
    stage.release()
    plain.release()


def test_a_directive_reaches_what_does_not_run_the_text(ctx):
    """Surfaces that are coloured without d_beckmann, by a word that a line before it gives another meaning."""
    stage, known, source, values = editable(step("microfacets/cook_torrance"), ctx)
    before, text = picture(stage, values), known["d_beckmann"].text
    stage.rewrite(edit.overrides({"d_beckmann": text + "\n"}, known, source))
    assert np.abs(picture(stage, values) - before).max() <= 1
    apart = dict(stage.own.made.drawn_by)
    stage.rewrite(edit.overrides({"d_beckmann": f"#define mix(a, b, t) (a)\n{text}"}, known, source))
    assert set(apart.values()) >= {"surface 2", "surface 3"} and len(set(stage.own.made.drawn_by.values())) == 1
    assert np.abs(picture(stage, values) - before).max() > 20
    stage.rewrite(edit.overrides({"d_beckmann": text + "\n"}, known, source))
    assert np.abs(picture(stage, values) - before).max() <= 1 and stage.own.made.drawn_by == apart
    stage.release()


def test_a_picked_pixel_follows_a_choice(ctx):
    board = step("plausible_shading/board")
    values = whole(board)
    stage, plain = on_stage(board, values, ctx), on_stage(board, values, ctx, decided=())
    camera = board.step.scene.camera
    for number in (0, 6):
        ours, theirs = (raw(one, values | {"shows": number}, camera, DARK, (24, 18)) for one in (stage, plain))
        for a, b in zip(ours, theirs, strict=True):
            assert np.allclose(a, b, atol=1e-4)
    stage.release()
    plain.release()


@pytest.mark.parametrize(("decided", "sentence"), [
    ("no_such", "the scene decides no_such, which is no choice"),
    ("panel_width", "the scene decides panel_width, which is no choice"),
    ("level", "the scene decides level, which is no choice"),
    ("shape", "its GLSL has no line `uniform int shape;`"),
])
def test_what_cannot_be_decided_is_refused(decided, sentence):
    scene = replace(WORK.step.scene, decided=(decided,))
    more = (Value("shape", 0, choices=("this", "that")),) if decided == "shape" else ()
    wrong = replace(WORK, step=replace(WORK.step, scene=scene, values=(*WORK.step.values, *more)))
    with pytest.raises(Problem, match=sentence.replace(".", r"\.")):
        values_of(wrong.step)
    assert any(sentence in said for _, said in faults(wrong))


def test_a_page_is_told_what_is_decided():
    scene = content(WORK)["scene"]
    assert scene["decided"] == ["light_shape", "sampling"]
    lines = {line for pair in scene["programs"].values() for text in pair for line in text.split("\n")}
    assert {"uniform int light_shape;", "uniform int sampling;"} <= lines
    plate = content(step("plausible_shading/texturing"))["scene"]
    text = "".join(part for pair in plate["programs"].values() for part in pair)
    assert plate["decided"] == [] and "own_albedo;" not in text and "albedo_map" not in text, "a page has no maps"


def test_inspect_tells_what_is_decided_and_compiled():
    found = inspect(WORK, defaults(WORK) | {"light_shape": 1})
    assert found.decided == {"light_shape": "disk", "sampling": "stratified"}
    assert "irradiance_disk_light" in found.functions and "irradiance_outline" in found.functions_left_out
    assert not {"light_shape", "sampling"} & set(found.uniforms) and found.faults == ()
    assert "decided     light_shape = disk, sampling = stratified" in inspected(found)


def test_inspect_of_all_says_which_steps_decide():
    rows = [Row(inspect(found), {"ratio": 0.5}, ()) for found in (WORK, step("solid_angle/cone"))]
    told = "\n".join(summary(rows, 2))
    assert "measured so: lights/area_work (light_shape, sampling)." in told and "0 faults" not in told


def test_a_surfaces_program_has_only_what_it_is_coloured_by():
    """The scales of a floor need nothing of its light."""
    known = {"light_shape": 0, "sampling": 2}
    floor, scale = (programs(WORK.step.scene, names=("surface",), known=known | {"surface": i})["surface"][1]
                    for i in (0, 1))
    assert "irradiance_light_sampled" in floor.kept and "irradiance_light_sampled" in scale.left_out
    assert len(scale.text) < 0.25 * len(floor.text)
