"""The stage's picture: places, depths, what one looks through, and the values behind a pixel."""

import numpy as np
import pytest

from app import optics, shader
from app.gpu.pick import pick
from app.gpu.scene_programs import MANY
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Dots, Label, Mark, Surface
from app.meshes import built_in
from app.problem import Problem
from app.stress.domain import cube
from lessons.ch01_solid_angle import PATCH
from tests.stage_help import ABOVE, BACKGROUND, DARK, SQUARE, build, drawn, is_alive, on_screen, picture, rays, watch

TWO_SPHERES = """
#include "optics/spherical.glsl"
uniform float radius;
vec3 centre(int surface) { return surface == 0 ? vec3(0.0) : vec3(0.6, 0.1, 0.3); }
vec3 surface_point(int surface, vec2 s) { return centre(surface) + radius * sphere_point(s.x, s.y); }
vec3 shade(Surface s) { return s.id == 0 ? vec3(0.1, 0.2, 0.3) : vec3(7.0, 0.4, 0.0); }
"""
CENTRES = np.array([[0, 0, 0], [0.6, 0.1, 0.3]])
SIDE = Camera(azimuth=-60.0, elevation=20.0, distance=5.0)
PATCH_VALUES = {"theta": 0.9, "phi": 0.3, "distance": 2.0, "tilt": 0.4, "width": 1.2, "samples": 300}


def spheres(**how) -> Stage:
    return build(TWO_SPHERES, surfaces=tuple(Surface(name, cells=(128, 64), **how) for name in ("first", "second")))


def test_the_same_values_give_the_same_picture_and_others_another(ctx):
    stage = spheres()
    for fine in (False, True):
        one = picture(stage, {"radius": 0.6}, SIDE, fine=fine)
        other = picture(stage, {"radius": 0.7}, SIDE, fine=fine)
        np.testing.assert_array_equal(picture(stage, {"radius": 0.6}, SIDE, fine=fine), one)
        assert drawn(other).sum() > 1.2 * drawn(one).sum()
    again = spheres()
    np.testing.assert_array_equal(picture(again, {"radius": 0.6}, SIDE, fine=True),
                                  picture(stage, {"radius": 0.6}, SIDE, fine=True))


def test_a_fine_picture_differs_at_edges_only(ctx):
    stage = spheres()
    fast, fine = (picture(stage, {"radius": 0.6}, SIDE, (128, 128), fine) for fine in (False, True))
    around = [np.roll(fast, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    same = np.all(np.stack(around) == fast, axis=(0, -1))
    assert same.any() and np.array_equal(fast[same], fine[same]) and (fast != fine).any()
    assert len(np.unique(fine.reshape(-1, 3), axis=0)) > len(np.unique(fast.reshape(-1, 3), axis=0)) == 3


def test_many_surfaces_share_a_program_until_each_has_its_own_and_look_the_same(ctx):
    """As in a window: one at a time; a text that is edited is shared by all again. One looks through its own."""
    glsl = TWO_SPHERES.replace("surface == 0 ? vec3(0.0) : vec3(0.6, 0.1, 0.3)", "0.25 * vec3(surface, surface % 3, 0)")
    glsl = glsl.replace("s.id == 0 ? vec3(0.1, 0.2, 0.3) : vec3(7.0, 0.4, 0.0)", "vec3(0.1 * float(s.id), 0.3, 0.2)")
    surfaces = tuple(Surface(f"{i}", cells=(24, 12), opacity=0.5 if i == MANY else 1.0) for i in range(MANY + 2))
    stage, values = build(glsl, surfaces=surfaces), {"radius": 0.4}

    def settled() -> int:
        rounds = 0
        while stage.settle(values, SIDE, DARK):
            rounds += 1
        return rounds

    before = picture(stage, values, SIDE, fine=True)
    assert settled() == MANY + 1 and len({stage.programs[f"surface {i}"].glo for i in range(MANY + 2)}) == MANY + 2
    np.testing.assert_array_equal(stage.picture.pixels(), before)
    np.testing.assert_array_equal(picture(stage, values, SIDE, fine=True), before)
    stage.rewrite((("scene", shader.Source(glsl.replace("0.3, 0.2", "0.1, 0.2"), "your scene", is_own=True)),))
    after = picture(stage, values, SIDE, fine=True)
    assert set(stage.programs) == {"typed vertices, pixels", f"surface {MANY}"} and (after != before).any()
    assert settled() == MANY + 1
    np.testing.assert_array_equal(picture(stage, values, SIDE, fine=True), after)


def test_the_nearer_surface_hides_the_farther_one(ctx):
    """Which sphere is seen, and where its surface is, from the ray of each pixel."""
    stage, size, radius = spheres(), (36, 30), 0.6
    values = {"radius": radius}
    picture(stage, values, SIDE, size)
    eye, way = rays(SIDE, size)
    b = np.einsum("hwk,ck->hwc", way, CENTRES - eye)
    under = b * b - np.sum((CENTRES - eye) ** 2, -1) + radius**2
    depth = np.where(under > 0, b - np.sqrt(np.abs(under)), np.inf)
    seen = {0: 0, 1: 0, None: 0}
    for row, column in np.ndindex(size[::-1]):
        if np.any(np.abs(under[row, column]) < 0.01):
            continue  # the very rim, where the triangles and the sphere part
        at = (column + 0.5) / size[0], (row + 0.5) / size[1]
        found, nearest = pick(stage, values, SIDE, DARK, at), int(np.argmin(depth[row, column]))
        if not np.isfinite(depth[row, column, nearest]):
            seen[None] += 1
            assert found is None
            continue
        seen[nearest] += 1
        assert found is not None and found.surface == ("first", "second")[nearest]
        point = eye + depth[row, column, nearest] * way[row, column]
        np.testing.assert_allclose(found.position, point, atol=6e-3)
    assert min(seen.values()) > 30


def test_a_pick_is_the_raw_radiance_to_float32(ctx):
    shade = "vec3 shade(Surface s) { return vec3(50.0 * s.position.x, s.st.y - 2.0, 1e-6 * s.position.y); }"
    stage = build(SQUARE + shade)
    size = (64, 48)
    camera = Camera(azimuth=-90.0, elevation=50.0, distance=4.0)
    picture(stage, {}, camera, size)
    eye, way = rays(camera, size)
    count = 0
    for row, column in np.ndindex(size[::-1]):
        x, y, z = eye - way[row, column] * (eye[2] / way[row, column, 2])
        if max(abs(x), abs(y)) > 1.0 - 1e-6:
            continue
        found = pick(stage, {}, camera, DARK, ((column + 0.5) / size[0], (row + 0.5) / size[1]))
        assert found is not None and found.surface == "square"
        np.testing.assert_allclose(found.position, (x, y, z), atol=4e-6)
        np.testing.assert_allclose(found.radiance, (50 * x, (y + 1) / 2 - 2, 1e-6 * y), rtol=1e-5, atol=2e-4)
        count += 1
    assert count > 500
    assert pick(stage, {}, camera, DARK, (0.01, 0.01)) is None


def test_a_pick_names_the_face_of_a_mesh(ctx):
    glsl = "vec3 mesh_point(int i, vec3 p) { return p; }\nvec3 shade(Surface s) { return vec3(float(s.face)); }"
    stage = build(glsl, cube(), surfaces=(Surface("cube", mesh=True),))
    picture(stage)
    above = {f for f, triangle in enumerate(cube()) if np.all(triangle[:, 2] > 0.5)}
    found = [pick(stage, {}, ABOVE, DARK, at) for at in ((0.4, 0.45), (0.6, 0.55), (0.6, 0.45), (0.4, 0.55))]
    assert {p.face for p in found if p} == above and all(p and p.radiance[0] == p.face for p in found)


SMOOTH = """
#include "stage/corner_normal.glsl"
vec3 mesh_point(int surface, vec3 p) { return p; }
vec4 mesh_value(int surface, vec3 p, int face) { return vec4(corner_normal(p, face), 0.0); }
vec3 shade(Surface s) { return 0.5 + 0.5 * normalize(s.value.xyz); }
"""


def test_a_mesh_has_smooth_normals_where_a_scene_asks_for_them(ctx):
    """A sphere of triangles is lit as the sphere itself, to what its flat faces hide; no other scene pays for it."""
    sphere = built_in("sphere").triangles
    stage = build(SMOOTH, triangles=sphere, surfaces=(Surface("sphere", mesh=True),))
    picture(stage, camera=SIDE)
    for x, y in ((0.5, 0.5), (0.45, 0.6), (0.58, 0.42)):
        found = pick(stage, {}, SIDE, DARK, (x, y))
        position = np.array(found.position)
        normal = 2 * np.array(found.radiance) - 1
        assert normal == pytest.approx(position / np.linalg.norm(position), abs=3e-3)
        a, b, c = sphere[found.face]
        flat = np.cross(b - a, c - a)
        assert np.abs(normal - flat / np.linalg.norm(flat)).max() > 3e-3, "the face itself is turned"
    assert "normals" in stage.data and "normals" not in spheres().data


def test_one_looks_through_a_surface_with_opacity(ctx):
    glsl = (SQUARE.replace("0.0);", "surface == 0 ? 0.0 : 0.2);")
            + "vec3 shade(Surface s) { return vec3(s.id == 0 ? 0.0 : 1.0); }")
    clear = build(glsl, surfaces=(Surface("below"), Surface("above", opacity=0.25)))
    assert np.all(np.abs(picture(clear)[48, 48] - 0.25 * 255) <= 1)
    hidden = build(glsl, surfaces=(Surface("above", opacity=0.25), Surface("below")))
    assert np.all(np.abs(picture(hidden)[48, 48] - 255) <= 1), "a surface's number is its place in the scene"
    assert pick(clear, {}, ABOVE, DARK, (0.5, 0.5)).surface == "below", "a pick looks through it too"


def test_an_empty_scene_is_the_background(ctx):
    stage = build("")
    assert np.all(picture(stage) == BACKGROUND) and not stage.picture.faults() and stage.probes({}).shape == (0, 4)


# --- marks, dots, probes -------------------------------------------------------------------------------------------
POINTS = [(0.3, 0.2, 0.1), (-0.8, 0.5, 0.0), (0.6, -0.6, -0.4), (0.0, 0.0, 0.9)]


@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("camera", [ABOVE, SIDE])
def test_a_dot_and_a_tip_lie_where_the_camera_projects(ctx, point, camera):
    x, y, z = point
    size, place = (200, 160), f"vec3({x:.2f}, {y:.2f}, {z:.2f})"
    dot = build(f"vec3 dot_point(int i) {{ return {place}; }}\nvec4 dot_colour(int i) {{ return vec4(1.0); }}",
                dots=Dots(1, 3.0))
    tip = build(f"vec3 mark_point(int mark, float t) {{ return {place}; }}", marks=(Mark("tip", tip="dot"),))
    for stage in (dot, tip):
        lit = picture(stage, {}, camera, size) - BACKGROUND
        weight = np.abs(lit).sum(-1)
        rows, columns = np.indices(weight.shape)
        centre = [np.sum(weight * (axis + 0.5)) / np.sum(weight) for axis in (columns, rows)]
        np.testing.assert_allclose(centre, on_screen(point, camera, size), atol=0.25)


def test_a_line_runs_from_its_first_point_to_its_last(ctx):
    ends, size = np.array([[-0.7, -0.5, 0.2], [0.8, 0.6, -0.3]]), (240, 200)
    a, b = (f"vec3({x}, {y}, {z})" for x, y, z in ends)
    for mark in (Mark("line"), Mark("arrow", tip="arrow"), Mark("arc", segments=12)):
        stage = build(f"vec3 mark_point(int mark, float t) {{ return mix({a}, {b}, t); }}", marks=(mark,))
        rows, columns = np.nonzero(drawn(picture(stage, {}, SIDE, size)))
        first, last = on_screen(ends, SIDE, size)
        across = last - first
        off = np.abs(across[0] * (rows + 0.5 - first[1]) - across[1] * (columns + 0.5 - first[0])) / np.hypot(*across)
        along = ((columns + 0.5 - first[0]) * across[0] + (rows + 0.5 - first[1]) * across[1]) / (across @ across)
        assert off.max() < (7 if mark.tip == "arrow" else 3)
        assert abs(along.min()) < 0.02 and abs(along.max() - 1) < 0.02


def test_lines_differ_also_without_colour(ctx):
    glsl = "vec3 mark_point(int mark, float t) { return vec3(1.8 * t - 0.9, 0.0, 0.0); }"
    ink = {line: drawn(picture(build(glsl, marks=(Mark("m", line=line),)), size=(300, 300))).sum()
           for line in ("solid", "dashed", "dotted", "dashdot")}
    assert ink["solid"] > ink["dashed"] > ink["dotted"] and len(set(ink.values())) == 4


def test_a_surface_hides_dots_and_marks_behind_it(ctx):
    parts = {"dots": Dots(1, 3.0), "marks": (Mark("m", width=4.0),)}
    glsl = SQUARE + "vec3 shade(Surface s) { return vec3(0.0); }\nvec4 dot_colour(int i) { return vec4(1.0); }\n"
    for z, is_seen in ((-0.06, False), (-1.0, False), (0.0, True), (0.2, True)):
        place = (f"vec3 dot_point(int i) {{ return vec3(0.4, 0.0, {z}); }}\n"
                 f"vec3 mark_point(int m, float t) {{ return vec3(-0.4, 0.2 * t, {z}); }}")
        lit = picture(build(glsl + place, **parts)).max(-1) > 200
        assert lit[:, :48].any() == lit[:, 48:].any() == is_seen


def test_a_tip_stands_whole_on_a_surface_and_is_hidden_well_behind_it(ctx):
    """It comes nearer by about its own size; an eye drawn on a floor seen at a slant is not cut in half."""
    glsl = SQUARE + "vec3 shade(Surface s) { return vec3(0.0); }\n"
    ink = {z: int((picture(build(glsl + f"vec3 mark_point(int m, float t) {{ return vec3(0.0, 0.0, {z}); }}",
                                 marks=(Mark("m", tip="dot"),))).max(-1) > 200).sum()) for z in (0.0, 0.3, -1.0)}
    assert ink[0.0] > 0.8 * ink[0.3] > 0 and ink[-1.0] == 0


def test_as_many_dots_as_the_value_says(ctx):
    glsl = "uniform int count;\nvec3 dot_point(int i) { return vec3(0.2 * float(i) - 0.8, 0.0, 0.0); }\n" \
           "vec4 dot_colour(int i) { return vec4(vec3(1.0), i == 1 ? 0.0 : 1.0); }"
    stage = build(glsl, dots=Dots("count", 2.0))
    ink = [drawn(picture(stage, {"count": n}, size=(300, 300))).sum() for n in (0, 1, 2, 3, 6)]
    one = ink[1]
    assert ink[0] == 0 < one and np.allclose(ink[2:], [one, 2 * one, 5 * one], rtol=0.2), "and alpha 0 hides one"


def test_probes_and_anchors_are_the_twins(ctx):
    """What the labels and handles of a lesson stand on, from the float64 twins."""
    stage = Stage(ctx, Source(PATCH.scene, "lessons/ch01_solid_angle.py"))
    v = {k: v for k, v in PATCH_VALUES.items() if k != "samples"}
    normal = optics.twin("patch_normal")(v["theta"], v["phi"], v["tilt"])
    centre, corner = (optics.twin("patch_point")(**v, s=s, t=t) for s, t in ((0.5, 0.5), (1.0, 0.0)))
    probes, anchors = stage.probes(PATCH_VALUES), stage.anchors(PATCH_VALUES)
    np.testing.assert_allclose(probes[:4, :3], [centre, centre + 0.55 * normal, 0.75 * centre, corner], atol=1e-6)
    assert np.all(probes[:, 3] == 1.0)
    np.testing.assert_allclose(anchors["normal"], centre + 0.55 * normal, atol=1e-6)
    np.testing.assert_allclose(anchors["line of sight"], 0.82 * centre, atol=1e-6)


def test_two_labels_one_probe(ctx):
    stage = build("vec4 probe(int i) { return vec4(float(i)); }", labels=(Label("a", 2), Label("b", 0)))
    np.testing.assert_array_equal(stage.probes({})[:, 0], [0.0, 1.0, 2.0])


# --- sizes and the end ---------------------------------------------------------------------------------------------
def test_sizes(ctx):
    stage = spheres()
    for size in ((96, 96), (33, 77), (1, 1), (300, 20)):
        for fine in (False, True):
            assert picture(stage, {"radius": 0.6}, SIDE, size, fine).shape == (size[1], size[0], 3)
    texture = stage.draw({"radius": 0.6}, SIDE, (64, 64), DARK)
    assert stage.draw({"radius": 0.9}, SIDE, (64, 64), DARK, fine=False) is texture, "the same until the size changes"
    assert stage.draw({"radius": 0.6}, SIDE, (0, -5), DARK).size == (1, 1), "a window folded away"
    wide, high = (picture(stage, {"radius": 0.6}, ABOVE, size) for size in ((200, 100), (100, 200)))
    assert abs(drawn(wide).sum() / drawn(high).sum() - 1) < 0.02, "neither cuts the scene"


def test_a_picture_larger_than_opengl_can_draw_is_refused_and_the_last_one_stays(ctx):
    stage, limit = build(SQUARE + "vec3 shade(Surface s) { return vec3(1.0); }"), ctx.info["GL_MAX_TEXTURE_SIZE"]
    before = picture(stage)
    with pytest.raises(Problem, match=f"{limit + 1} x 10 pixels is larger than this OpenGL can draw"):
        stage.draw({}, ABOVE, (limit + 1, 10), DARK)
    np.testing.assert_array_equal(stage.picture.pixels(), before)


def test_everything_is_given_back(ctx, monkeypatch):
    made = watch(monkeypatch)
    stage = build(TWO_SPHERES + "vec3 mesh_point(int s, vec3 p) { return p; }\n"
                  "vec3 mark_point(int m, float t) { return vec3(t); }\nvec4 probe(int i) { return vec4(1.0); }",
                  cube(), surfaces=(Surface("a"), Surface("b", mesh=True)), marks=(Mark("a", label="x"),),
                  labels=(Label("l", 0),))
    for size in ((64, 64), (32, 32)):
        for fine in (False, True):
            picture(stage, {"radius": 1.0}, SIDE, size, fine)
    pick(stage, {"radius": 1.0}, SIDE, DARK, (0.5, 0.5))
    stage.probes({}), stage.anchors({}), stage.place(cube(0.5)), stage.release()
    left = [thing for thing in made if is_alive(thing)]
    assert len(made) > 25 and [thing.size for thing in left] in ([], [(1, 1)]), "at most the context's one pixel"


def test_a_mistake_in_a_scene_names_the_lessons_line(ctx):
    with pytest.raises(Problem, match=r"lessons/test\.py, line 3: .*undeclared"):
        build(SQUARE + "vec3 shade(Surface s) {\n    return vec3(brightness);\n}")
    with pytest.raises(Problem, match=r"glsl/stage/shade\.frag, line \d+: .*shade"):
        build(SQUARE)


# --- what scenes are drawn with --------------------------------------------------------------------------------------
def test_a_value_of_the_corners_arrives_between_them(ctx):
    glsl = SQUARE + ("vec4 surface_value(int surface, vec2 s) { return vec4(s.x, 3.0 * s.y, s.x * s.y, 7.0); }\n"
                     "vec3 shade(Surface s) { return vec3(s.value.xy, s.value.z); }")
    stage, size = build(glsl), (64, 48)
    picture(stage, {}, size=size)
    for at in ((0.4, 0.45), (0.55, 0.6)):
        found = pick(stage, {}, ABOVE, DARK, at)
        s = (np.array(found.position[:2]) + 1) / 2
        np.testing.assert_allclose(found.radiance[:2], (s[0], 3 * s[1]), atol=1e-5)
        assert abs(found.radiance[2] - s[0] * s[1]) > 0.01, "one cell: between its corners linear"
    glsl = "vec3 mesh_point(int i, vec3 p) { return p; }\n" \
           "vec4 mesh_value(int i, vec3 p, int face) { return vec4(float(face)); }\n" \
           "vec3 shade(Surface s) { return s.value.xyz - float(s.face); }"
    mesh = build(glsl, cube(), surfaces=(Surface("cube", mesh=True),))
    picture(mesh)
    assert pick(mesh, {}, ABOVE, DARK, (0.45, 0.45)).radiance == (0.0, 0.0, 0.0)


def test_a_ball_is_the_true_sphere_at_each_pixel(ctx):
    """Few cells towards the eye; the normal is where the pixel's ray meets the sphere, to float32."""
    glsl = ('#include "display/balls.glsl"\nconst vec3 C = vec3(0.2, -0.1, 0.3);\n'
            "vec3 surface_point(int surface, vec2 s) { return cap_to_eye(s, C, 0.8); }\n"
            "vec3 shade(Surface s) { return ball_normal((s.position - C) / 0.8, s.v); }")
    stage, size, centre = build(glsl, surfaces=(Surface("ball", cells=(48, 3)),)), (40, 32), np.array([0.2, -0.1, 0.3])
    picture(stage, {}, SIDE, size)
    eye, way = rays(SIDE, size)
    seen = 0
    for row, column in np.ndindex(size[::-1]):
        d = way[row, column]
        b = d @ (centre - eye)
        under = b * b - (centre - eye) @ (centre - eye) + 0.64
        if abs(under) < 0.01:
            continue  # the rim, of 48 sides
        found = pick(stage, {}, SIDE, DARK, ((column + 0.5) / size[0], (row + 0.5) / size[1]))
        assert (found is not None) == (under > 0)
        if found:
            normal = (eye + (b - np.sqrt(under)) * d - centre) / 0.8
            np.testing.assert_allclose(found.radiance, normal, atol=2e-5)
            seen += 1
    assert seen > 100
