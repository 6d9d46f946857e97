"""NaN, Inf and negative radiance are never hidden: counted to the pixel, marked with a colour and a pattern."""

import numpy as np
import pytest

from app.gpu.picture import Faults
from app.gpu.stage import Stage
from app.lesson import Dots, Mark, Surface
from tests.stage_help import ABOVE, SQUARE, build, on_screen, picture

SIZE = (200, 150)
BAD = {"nan": ("vec3(0.5, zero / zero, 0.5)", (1, 0, 0)), "inf": ("vec3(1.0 / zero, 0.5, 0.5)", (0, 1, 0)),
       "negative": ("vec3(0.5, 0.5, zero - 1e-30)", (0, 0, 1)), "minus inf": ("vec3(-1.0 / zero, 0.5, 0.5)", (0, 1, 1)),
       "all": ("vec3(zero / zero, -1.0, 1.0 / zero)", (1, 1, 1)), "none": ("vec3(0.0, 1.0, 1e30)", (0, 0, 0)),
       "square root": ("vec3(sqrt(zero - 1.0))", (1, 0, 0)), "logarithm": ("vec3(-log(zero))", (0, 1, 0))}
COLOURS = {"nan": {(255, 0, 255), (0, 0, 0)}, "inf": {(0, 255, 255), (0, 0, 0)}, "negative": {(255, 0, 0), (51, 0, 0)}}
HEAD = "uniform float zero;\n"


def fault(stage: Stage, fine: bool = False) -> Faults:
    picture(stage, {"zero": 0.0}, size=SIZE, fine=fine)
    return stage.picture.faults()


def covered(low: tuple[float, float], high: tuple[float, float]) -> np.ndarray:
    """The pixels whose centres lie in a rectangle of the plane z = 0, seen from above."""
    (x0, y1), (x1, y0) = (on_screen((*corner, 0.0), ABOVE, SIZE) for corner in (low, high))
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5, np.arange(SIZE[1]) + 0.5)
    return (x > x0) & (x < x1) & (y > y0) & (y < y1)


@pytest.mark.parametrize("name", BAD)
def test_the_count_is_the_area(ctx, name):
    """The left part of a square is bad: as many pixels as have their centre there, no more, no fewer."""
    text, kinds = BAD[name]
    stage = build(HEAD + SQUARE + f"vec3 shade(Surface s) {{ return s.st.x < 0.371 ? {text} : vec3(0.5); }}")
    area = int(covered((-1.0, -1.0), (2 * 0.371 - 1, 1.0)).sum())
    expected = Faults(*(area * kind for kind in kinds))
    assert area > 2000 and fault(stage) == expected
    fine = fault(stage, fine=True)
    rim = 2 * (SIZE[0] + SIZE[1])
    for kind in ("nan", "inf", "negative"):
        count, exact = getattr(fine, kind), getattr(expected, kind)
        assert exact <= count <= (exact + rim if exact else 0), "a pixel of which a part is bad counts"


@pytest.mark.parametrize("name", COLOURS)
@pytest.mark.parametrize("fine", [False, True])
def test_each_kind_has_its_colour_and_pattern(ctx, name, fine):
    stage = build(HEAD + SQUARE + f"vec3 shade(Surface s) {{ return s.st.x < 0.371 ? {BAD[name][0]} : vec3(0.5); }}")
    pixels = picture(stage, {"zero": 0.0}, size=SIZE, fine=fine)
    inside = covered((-0.97, -0.97), (2 * 0.371 - 1.03, 0.97))
    found, counts = np.unique(pixels[inside], axis=0, return_counts=True)
    assert set(map(tuple, found.tolist())) == COLOURS[name]
    assert counts.min() > 0.2 * counts.sum(), "a pattern, that greyscale shows too"
    healthy = covered((2 * 0.371 - 0.97, -0.97), (0.97, 0.97))
    assert np.all(pixels[healthy] == 188), "sRGB of 0.5, and nothing bad beside it"


def test_three_kinds_at_once(ctx):
    shade = "vec3 shade(Surface s) { return s.st.x < 0.25 ? %s : s.st.x < 0.5 ? %s : s.st.y < 0.5 ? %s : vec3(0.5); }"
    stage = build(HEAD + SQUARE + shade % tuple(BAD[kind][0] for kind in ("nan", "inf", "negative")))
    areas = [int(covered(low, high).sum()) for low, high in
             (((-1, -1), (-0.5, 1)), ((-0.5, -1), (0, 1)), ((0, -1), (1, 0)))]
    found = fault(stage)
    for count, area in zip((found.nan, found.inf, found.negative), areas, strict=True):
        assert abs(count - area) <= SIZE[1], "to the pixel row"
    assert found


def test_a_bad_value_can_come_from_a_uniform_too(ctx):
    stage = build("uniform float brightness;\n" + SQUARE + "vec3 shade(Surface s) { return vec3(brightness); }")
    area = int(covered((-1, -1), (1, 1)).sum())
    for value, expected in ((np.nan, Faults(nan=area)), (np.inf, Faults(inf=area)), (-0.1, Faults(negative=area)),
                            (0.3, Faults()), (-0.0, Faults())):
        picture(stage, {"brightness": value}, size=SIZE)
        assert stage.picture.faults() == expected


LAYERS = ("uniform float zero;\nvec3 surface_point(int surface, vec2 s) {\n"
          "    return vec3(2.0 * s - 1.0, surface == 0 ? 0.0 : 0.5);\n}\n")


def test_a_bad_surface_one_looks_through_is_seen_in_full(ctx):
    """Opacity never dims a fault, and a healthy pane before a bad wall does not take it from the count."""
    glsl = LAYERS + "vec3 shade(Surface s) { return s.id == %d ? vec3(zero / zero) : vec3(0.5); }"
    pane = (Surface("wall", cells=(1, 1)), Surface("pane", cells=(1, 1), opacity=0.1))
    front = build(glsl % 1, surfaces=pane)
    assert fault(front).nan > int(covered((-1, -1), (1, 1)).sum()), "the pane is nearer, so it looks larger"
    seen = set(map(tuple, front.picture.pixels()[SIZE[1] // 2 - 20:SIZE[1] // 2 + 20, 80:120].reshape(-1, 3).tolist()))
    assert seen == COLOURS["nan"]
    assert fault(build(glsl % 0, surfaces=pane)).nan == int(covered((-1, -1), (1, 1)).sum())


def test_what_is_hidden_by_a_wall_does_not_count(ctx):
    glsl = LAYERS + "vec3 shade(Surface s) { return s.id == 0 ? vec3(zero / zero) : vec3(0.5); }"
    wall = (Surface("behind", cells=(1, 1)), Surface("before", cells=(1, 1)))
    assert fault(build(glsl, surfaces=wall)) == Faults()
    assert fault(build(glsl, surfaces=(Surface("behind", cells=(1, 1), opacity=0.5), wall[1]))) == Faults()


def test_a_bad_dot_is_seen(ctx):
    glsl = HEAD + "vec3 dot_point(int i) { return vec3(0.5 * float(i), 0.0, 0.0); }\n" \
                  "vec4 dot_colour(int i) { return vec4(i == 0 ? %s : vec3(0.5), 0.3); }"
    for name, kind in (("nan", 0), ("inf", 1), ("negative", 2)):
        stage = build(glsl % BAD[name][0], dots=Dots(2, 3.0))
        one = fault(stage)
        counts = (one.nan, one.inf, one.negative)
        assert counts[kind] > 20 and sum(counts) == counts[kind] < 400, "the one dot, not both"
    assert not fault(build(glsl % "vec3(0.1)", dots=Dots(2, 3.0)))


def test_a_mark_over_a_fault_hides_no_count(ctx):
    glsl = HEAD + SQUARE + "vec3 shade(Surface s) { return vec3(zero / zero); }\n" \
                           "vec3 mark_point(int m, float t) { return vec3(2.0 * t - 1.0, 0.0, 0.1); }"
    plain = fault(build(glsl))
    assert fault(build(glsl, marks=(Mark("m", width=4.0),))) == plain


def test_the_next_picture_starts_clean(ctx):
    stage = build("uniform float brightness;\n" + SQUARE + "vec3 shade(Surface s) { return vec3(brightness); }")
    for fine in (False, True):
        for value in (-1.0, 0.5):
            picture(stage, {"brightness": value}, fine=fine)
            assert bool(stage.picture.faults()) == (value < 0)
