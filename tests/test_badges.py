"""Badges: which reflectance is green or red where, with the value that theory gives; and the sum they rest on."""

import json
import math

import numpy as np
import pytest

from app import badges, catalog, furnace
from app.badges import NAMES, check, told
from app.export import gallery, target
from app.export.page import page
from app.export.still import still
from app.inspection import inspect, words
from app.lesson import Model, Term
from app.optics.lambert import brdf_lambert
from app.optics.weak_furnace import albedo_without_g
from app.problem import Usage
from app.session import Session
from app.state import defaults
from app.terms import vector
from app.theme import THEMES, colour
from app.validation import validate
from tests import small_lesson
from tests.small_lesson import model_lesson

PI = np.pi


def lit(f, l, v):
    return np.where((l[..., 2] > 0) & (v[..., 2] > 0), f, 0.0)


def lambert(rho):
    return lambda n, l, v: brdf_lambert(n, l, v, rho)


def from_mirror(l, v):
    """1 - r.v, without losing digits."""
    return 0.5 * np.sum((l * (-1, -1, 1) - v) ** 2, -1)


def phong(exponent, scale=None):
    """(r.v)^exponent, normalised by (exponent + 2) / 2 pi: its albedo at theta_v 0 is 1."""
    c = (exponent + 2) / (2 * PI) if scale is None else scale

    def f(n, l, v):
        away = from_mirror(l, v)
        return lit(np.where(away < 1, c * np.exp(exponent * np.log1p(-np.minimum(away, 1 - 1e-12))), 0), l, v)

    return f


def slope(l, v):
    """tan^2 of the angle between n and h."""
    s = l + v
    return (s[..., 0] ** 2 + s[..., 1] ** 2) / np.maximum(s[..., 2], 1e-200) ** 2


def blinn(exponent, normalised=True):
    c = (exponent + 2) * (exponent + 4) / (8 * PI * (exponent + 2 ** (-exponent / 2))) if normalised else 1.0
    return lambda n, l, v: lit(c * np.exp(-exponent / 2 * np.log1p(np.minimum(slope(l, v), 1e18))), l, v)


def cook_torrance(m, prefactor=0.25):
    """Beckmann's D, the V-groove's G, F = 1."""
    def f(n, l, v):
        s, t2 = l + v, np.minimum(slope(l, v), 1e18)
        length = np.linalg.norm(s, axis=-1)
        d = np.exp(-t2 / m**2 - math.log(PI * m * m)) * (1 + t2) ** 2
        n_dot_h, l_dot_h = s[..., 2] / length, length / 2
        g = np.minimum(1, 2 * n_dot_h * np.minimum(l[..., 2], v[..., 2]) / l_dot_h)
        return lit(np.nan_to_num(prefactor * d * g / (l[..., 2] * v[..., 2])), l, v)

    return f


def sent_back(exponent):
    """A lobe about the eye, as of a cat's eye."""
    return lambda n, l, v: lit((exponent + 2) / (2 * PI) * np.exp(
        exponent * np.log1p(-np.minimum(0.5 * np.sum((l - v) ** 2, -1), 1 - 1e-12))), l, v)


def angles_of(badge):
    return {name: math.degrees(value) for name, value in badge.at.items()}


TABLE = {  # a reflectance, what is said with it, and what is red: badge -> worst value, how near, angles (degrees)
    "Lambert": (lambert(0.8), {}, {}),
    "Lambert, more than it gets": (lambert(1.2), {}, {"energy": (1.2, 1e-9, {"theta_v": 0})}),
    "Lambert, negative": (lambert(-0.1), {}, {"non_negative": (-0.1 / PI, 1e-12, None)}),
    "Phong's lobe, normalised": (phong(20), {}, {}),
    "Phong's lobe, very narrow": (phong(1e7), {}, {}),
    "Phong, 1977": (phong(20, 1.0), {"shading": True}, {"reciprocal": (0.93, 0.05, None),
                                                        "energy": (3.028, 0.01, {"theta_l": 89.5})}),
    "divided by n.l": (lambda n, l, v: lit(0.1 / np.maximum(l[..., 2], 1e-300), l, v), {},
                       {"reciprocal": None, "energy": (0.1 * PI / math.cos(math.radians(89.5)), 0.03,
                                                       {"theta_l": 89.5})}),
    "Phong, 1977, broad": (phong(0, 1.0), {"shading": True},
                           {"reciprocal": (0.93, 0.06, None), "energy": (2 * PI, 1e-3, {"theta_v": 0})}),
    "Blinn-Phong": (blinn(20), {}, {}),
    "Blinn-Phong, very narrow": (blinn(1e7), {}, {}),
    "Blinn's lobe, unnormalised": (blinn(1, False), {},
                                   {"energy": (8 * PI * (1 + 2**-0.5) / 15, 1e-4, {"theta_v": 0})}),
    "Cook-Torrance": (cook_torrance(0.3), {}, {}),
    "Cook-Torrance, smooth": (cook_torrance(1e-4), {}, {}),
    "Cook-Torrance, 1/pi, m = 0.1": (cook_torrance(0.1, 1 / PI), {}, {"energy": (1.2732, 1e-3, {"theta_v": 0})}),
    "Cook-Torrance, 1/pi, m = 0.8": (cook_torrance(0.8, 1 / PI), {}, {"energy": (1.27003, 1e-4, {"theta_v": 89.5})}),
    "a cat's eye": (sent_back(1e6), {}, {}),
    "a cat's eye, too bright": (lambda n, l, v: 1.1 * sent_back(1e6)(n, l, v), {},
                                {"energy": (1.1, 1e-3, {"theta_v": 0})}),
    "one side only": (lambda n, l, v: np.where(l[..., 2] > 0, v[..., 2] ** 2 / PI, 0.0), {},
                      {"reciprocal": (0.9988, 1e-3, None)}),
    "divided by n.v": (lambda n, l, v: 0.1 / np.where(l[..., 2] > 0, v[..., 2], np.inf), {},
                       {"non_negative": None, "reciprocal": None, "energy": None, "finite": (None, 0, None)}),
    "a clamped picture": (lambda n, l, v, radiance: np.minimum(lambert(0.8)(n, l, v) * radiance, 1.0),
                          {"of_radiance": True}, {"linear": (1 - 1e-3 * PI / 0.8, 1e-9, None)}),
    "a linear formula": (lambda n, l, v, radiance: lambert(0.8)(n, l, v) * radiance, {"of_radiance": True}, {}),
}


@pytest.mark.parametrize("name", TABLE)
def test_badges_are_green_and_red_where_theory_says(name):
    reflect, how, red = TABLE[name]
    found = check(reflect, **how)
    assert tuple(found) == NAMES
    assert {name for name in NAMES if not found[name].ok} == set(red)
    for badge, wanted in red.items():
        if wanted is None:
            continue
        worst, near, at = wanted
        assert found[badge].worst == (worst if worst is None else pytest.approx(worst, abs=near)), badge
        if at is not None:
            assert angles_of(found[badge]) == pytest.approx(at)
    json.dumps(badges.as_json(found), allow_nan=False)


def test_light_is_made_at_grazing_incidence_by_phong_s_formula():
    """int (r.v)^e n.v dw / n.l by many plain cells around r, those below the horizon left out."""
    exponent, theta_l = 20, math.radians(89.5)
    t, s = (np.arange(4000) + 0.5)[:, None] / 4000 * PI / 2, (np.arange(2000) + 0.5) / 2000 * PI
    n_dot_v = np.maximum(math.cos(theta_l) * np.cos(t) + math.sin(theta_l) * np.sin(t) * np.cos(s), 0)
    flux = 2 * np.sum(np.cos(t) ** exponent * n_dot_v * np.sin(t)) * (PI / 2 / 4000) * (PI / 2000)
    badge = check(phong(exponent, 1.0), shading=True)["energy"]
    assert badge.worst == pytest.approx(flux / math.cos(theta_l), rel=2e-3)


def test_the_pair_that_is_told_is_not_reciprocal():
    f = TABLE["Phong, 1977"][0]
    badge = check(f, shading=True)["reciprocal"]
    from app.optics.spherical import direction

    n, l, v = np.array([0, 0, 1.0]), direction(badge.at["theta_l"], badge.at["phi"]), direction(badge.at["theta_v"], 0)
    there, back = f(n, l, v) / l[2], f(n, v, l) / v[2]
    assert 1 - min(there, back) / max(there, back) == pytest.approx(badge.worst, rel=1e-9)
    assert 1 - math.cos(badge.at["theta_v"]) / math.cos(badge.at["theta_l"]) == pytest.approx(badge.worst, rel=1e-6)


def test_what_is_not_finite_is_told_with_its_place():
    def f(n, l, v):
        s = l + v
        with np.errstate(all="ignore"):
            return lit(s[..., 2] / np.linalg.norm(s, axis=-1), l, v) + 0 / np.linalg.norm(s, axis=-1)

    badge = check(f)["finite"]
    assert (badge.ok, badge.worst) == (False, None), "0 / 0 at l = -v"


FLAWED = {  # a value over the pairs l, v, and what is red; every worst value there is none
    "no number at all": (lambda l, v: np.nan, {"non_negative", "reciprocal", "energy", "finite"}),
    "infinite": (lambda l, v: np.inf, {"reciprocal", "energy", "finite"}),
    "endlessly negative": (lambda l, v: -np.inf, {"non_negative", "reciprocal", "energy", "finite"}),
    "no number on one half": (lambda l, v: np.where(l[..., 0] > 0, np.nan, 0.1), {"reciprocal", "energy", "finite"}),
    "infinite for low light": (lambda l, v: np.where(l[..., 2] < 0.2, np.inf, 0.1), {"reciprocal", "energy", "finite"}),
    "no number where l is v": (lambda l, v: 0.1 + 0 / np.sum((l - v) ** 2, -1), {"finite"}),
    "beyond the largest float": (lambda l, v: 1e308 * (l[..., 2] > 0), {"energy"}),
}


@pytest.mark.parametrize("name", FLAWED)
@pytest.mark.parametrize("of_radiance", [False, True])
def test_what_is_no_number_keeps_no_promise(name, of_radiance):
    value, red = FLAWED[name]

    def f(n, l, v, radiance=1.0):
        found = np.broadcast_to(value(*np.broadcast_arrays(l, v)), np.broadcast_shapes(l.shape, v.shape)[:-1])
        return found * radiance if of_radiance else found

    found = check(f, of_radiance=of_radiance)
    nowhere = ("no number at all", "infinite", "endlessly negative", "beyond the largest float")
    overflows = of_radiance and name in nowhere
    assert {name for name in NAMES if not found[name].ok} == red | ({"linear"} if overflows else set())
    assert all(found[name].worst is None for name in red)
    for badge in found:
        assert "nan" not in told(badge, found[badge]) or found[badge].ok
    json.dumps(badges.as_json(found), allow_nan=False)


ALBEDOS = {  # closed forms, and the table of optics.md D1 and D7; how near
    "Lambert": (lambert(0.8), (0, 30, 60, 85), (0.8, 0.8, 0.8, 0.8), 3e-4),
    "Cook-Torrance 0.3": (cook_torrance(0.3), (0, 60), (0.9956, 0.9248), 3e-4),
    "Cook-Torrance 0.5": (cook_torrance(0.5), (0,), (0.8924,), 3e-4),
    "Cook-Torrance 1": (cook_torrance(1.0), (0, 60, 85), (0.4534, 0.7917, 0.9695), 4e-4),
    "printed 1": (cook_torrance(1.0, 1 / PI), (0, 60, 85), (0.5773, 1.0080, 1.2344), 4e-4),
    "Blinn-Phong 1": (blinn(1), (0, 30, 60, 85), (1, 0.955, 0.819, 0.633), 6e-4),
    "Blinn-Phong 10": (blinn(10), (0, 30, 60, 85), (1, 0.805, 0.400, 0.135), 6e-4),
    "Blinn-Phong 100": (blinn(100), (0, 30, 60, 85), (1, 0.755, 0.265, 0.025), 6e-4),
    "Blinn-Phong 20": (blinn(20), (math.degrees(0.7),), (0.628119765165,), 1e-5),
    "Cook-Torrance 0.4": (cook_torrance(0.4), (math.degrees(0.7),), (0.919767901032,), 3e-4),
    "Cook-Torrance 0.15": (cook_torrance(0.15), (math.degrees(1.2),), (0.963624147079,), 5e-4),
    "a mirror's Phong lobe": (phong(1e7), (0, 30, 60, 85), np.cos(np.radians((0, 30, 60, 85))), 3e-4),
    "a mirror's Blinn lobe": (blinn(1e7), (0, 30, 60, 85), np.cos(np.radians((0, 30, 60, 85))) ** 2, 3e-4),
    "a mirror": (cook_torrance(1e-4), (0, 30, 60, 85, 89), np.ones(5), 3e-4),
    "a cat's eye": (sent_back(1e5), (0, 30, 60, 85), np.cos(np.radians((0, 30, 60, 85))), 3e-4),
    "a little mirror on Lambert": (lambda n, l, v: 0.99 * lambert(1)(n, l, v) + 0.01 * cook_torrance(1e-4)(n, l, v),
                                   (0, 30, 60, 85), np.ones(4), 3e-4),
}


@pytest.mark.parametrize("name", ALBEDOS)
def test_the_furnace_finds_the_light_of_any_lobe(name):
    f, angles, wanted, near = ALBEDOS[name]
    value, error = furnace.albedo(f, np.radians(angles))
    assert value == pytest.approx(np.array(wanted), abs=near)
    assert np.all(error < 0.01), "it says how sure it is"


def test_a_step_s_model_takes_its_arguments_from_the_values():
    model = Model("matt", Term("brdf_lambert", {"rho": "k_d"}))
    assert badges.of_model(model, {"k_d": 0.9, "theta_v": 0.3})["energy"].worst == pytest.approx(0.9, abs=1e-6)
    assert not badges.of_model(model, {"k_d": 1.5})["energy"].ok


TWINS = {  # the course's own: arguments, and what is red with its worst value; closed forms where there is one
    "brdf_lambert": ({"rho": 1.0}, {}),
    "brdf_phong": ({"exponent": 40.0}, {}),
    "shading_phong": ({"exponent": 40.0}, {"reciprocal": None, "energy": 0.5 * PI + 0.5 * 2 * PI / 41}),
    "brdf_phong_printed": ({"exponent": 1e5}, {"reciprocal": None, "energy": 0.5 * PI}),
    "brdf_blinn_phong": ({"exponent": 1e7}, {}),
    "shading_blinn_phong": ({"exponent": 10.0}, {"reciprocal": None, "energy": 0.5 * PI + 4 * PI * (1 - 2**-6) / 12}),
    "brdf_cook_torrance": ({"m": 1e-4}, {}),
    "brdf_cook_torrance_printed": ({"m": 0.1}, {"energy": 4 / PI}),
    "brdf_ggx": ({"alpha": 0.5}, {}),
    "brdf_eon": ({"rho": 1.0, "roughness": 1.0}, {}),
    "brdf_oren_nayar": ({"rho": 1.0}, {"energy": 1 - 0.09 / (2 * 0.09 + 0.66) + 0.5 * 0.45 * 0.09 / (0.09 + 0.09)}),
}
GEOMETRY = {  # the geometry term of brdf_geometry -> which badge is red, and its worst value
    1: {}, 2: {}, 3: {}, 0: {"energy": None},
}
ORDINARY = {"k_d": 0.5, "k_s": 0.5, "f0": 1.0, "rho": 0.8, "sigma": 0.3}


@pytest.mark.parametrize("function", TWINS)
def test_the_course_s_models_are_what_the_lessons_say(function):
    args, red = TWINS[function]
    found = badges.of_model(Model(function, Term(function)), ORDINARY | args)
    assert {name for name in NAMES if not found[name].ok} == set(red)
    if red.get("energy"):
        assert found["energy"].worst == pytest.approx(red["energy"], abs=2e-3)


@pytest.mark.parametrize("geometry", GEOMETRY)
@pytest.mark.parametrize("m", [0.1, 0.5, 1.0])
def test_only_without_a_geometry_term_light_is_made(geometry, m):
    """Worst at the lowest eye that is tried; the factor there is the twin's albedo."""
    found = badges.of_model(Model("G", Term("brdf_geometry", {"geometry": geometry, "m": m})), ORDINARY)
    assert {name for name in NAMES if not found[name].ok} == set(GEOMETRY[geometry])
    if geometry == 0:
        at = found["energy"].at["theta_v"]
        assert at > 1.5 and found["energy"].worst == pytest.approx(float(albedo_without_g(at, m)), rel=2e-2)


def test_what_a_badge_tells():
    found = check(TABLE["Phong, 1977, broad"][0], shading=True)
    assert told("energy", found["energy"]) == "It sends on 6.28 times the light that comes, at θ of the eye 0°."
    assert told("reciprocal", found["reciprocal"]).startswith("Swap light and eye, and 9")
    assert told("linear", found["linear"]) == "Twice the light gives twice the answer."
    broken = check(TABLE["divided by n.v"][0])
    assert told("finite", broken["finite"]).startswith("It is no number, or infinite, at θ of the light")
    assert told("non_negative", broken["non_negative"]).startswith("It is negative")


def test_a_step_stands_where_a_badge_points(tmp_path):
    """Angles it has, within their ranges; the mirror image where the azimuth allows only that."""
    session = Session("small/open", folder=model_lesson(tmp_path))
    session.stand({"theta_l": 1.1, "theta_v": 1.5, "phi": -2.0})
    assert {n: session.values[n] for n in ("theta_l", "theta_v", "phi")} == {"theta_l": 1.1, "theta_v": 1.5, "phi": 2.0}
    session.stand({"theta_v": 3.0})
    assert session.values["theta_v"] == PI / 2
    session.undo()
    assert session.values["theta_v"] == 1.5
    session.freeze()
    with pytest.raises(Usage):
        session.stand({"theta_v": 0.0})


def test_the_gallery_has_all_plots_and_badges(tmp_path, ctx):
    found = catalog.step("small/open", model_lesson(tmp_path))
    shown = gallery.rendered(found, target.make_folder(tmp_path / "out" / "pictures").parent, THEMES["dark"], scale=0.2)
    assert not shown.fault
    assert len(shown.plots) == 2 and all((tmp_path / "out" / file).is_file() for file in shown.plots)
    text = page([(found.loaded, [shown])])
    assert text.count('class="broken"') == 2 and text.count('class="kept"') == 8
    assert 'title="It sends on 1.' in text


def test_inspect_and_stills_have_the_badges(tmp_path, ctx):
    folder = model_lesson(tmp_path)
    found = catalog.step("small/open", folder)
    inspected = inspect(found)
    assert [name for name, one in inspected.badges["printed"].items() if not one["ok"]] == ["reciprocal", "energy"]
    assert "NOT reciprocal" in words(inspected)
    picture = np.asarray(still(found, defaults(found), None, (1280, 720)))
    for name in ("v", "r"):
        wanted = np.round(255 * np.array(colour(name, THEMES["dark"])))
        assert (np.abs(picture[550:].astype(int) - wanted).max(-1) <= 3).sum() > 100, name


@pytest.mark.parametrize(("old", "new", "sentence"), [
    ('Term("brdf_phong")', 'Term("f_schlick")', "f_schlick is neither a brdf_ nor a shading_."),
    ('Term("brdf_phong")', 'Term("brdf_eon_at")', "brdf_eon_at takes no l."),
    ('Term("brdf_phong")', 'Term("brdf_fong")', "there is no function brdf_fong. Did you mean "),
    ('Term("brdf_phong")', 'Term("brdf_phong", {"k_s": "gloss"})', "gloss of brdf_phong is neither given nor a value."),
])
def test_a_wrong_model_is_told_with_its_line(old, new, sentence, tmp_path):
    folder = model_lesson(tmp_path)
    file = folder / "ch01_small.py"
    file.write_text(file.read_text("utf-8").replace(old, new), "utf-8")
    catalog.forget()
    (loaded,) = catalog.chapters(folder)
    found = [fault for fault in validate(loaded) if sentence in fault]
    assert found and found[0].startswith(f"lessons/ch01_small.py, line {small_lesson.line(folder, new)}: ")


def test_a_plot_of_models_needs_some(tmp_path):
    curves = 'Curves("Cone", "half_angle", (Curve("cone", Term("solid_angle_cone")),), "sr")'
    folder = small_lesson.write(tmp_path, (f"plot={curves}", 'plot=Lobes("Lonely")'))
    (loaded,) = catalog.chapters(folder)
    assert any("the plot 'Lonely' shows models, and neither it nor the step has any." in f for f in validate(loaded))


def test_vectors_follow_from_the_angles(tmp_path):
    """n, l, v and h are no values; a scene that asks for them is told what to do."""
    found = catalog.step("small/open", model_lesson(tmp_path))
    assert not {"n", "l", "v", "h"} & set(found.values)
    values = {"theta_l": 0.7, "phi": 2.0, "theta_v": 0.3}
    l, v, h = (vector(name, values) for name in ("l", "v", "h"))
    assert l == pytest.approx([math.sin(0.7) * math.cos(2), math.sin(0.7) * math.sin(2), math.cos(0.7)])
    assert v == pytest.approx([math.sin(0.3), 0, math.cos(0.3)])
    assert h == pytest.approx((l + v) / np.linalg.norm(l + v))
    folder = small_lesson.write(tmp_path, ("uniform int samples;", "uniform int samples;\nuniform vec3 l;"))
    (loaded,) = catalog.chapters(folder)
    assert "light_direction(theta_l, phi)" in validate(loaded)[0]
