"""Every model of the course and every distribution of facets has its study, by every method there is a use for."""

import re
from dataclasses import replace

import numpy as np
import pytest

from app.catalog import step, steps
from app.lesson import Method
from app.optics import arguments, names, twin
from app.study.integrals import Integral
from app.study.measure import cases, measure, reference, seen, worst
from app.study.rules import estimate

STUDIED = [(found, study) for found in steps() for study in found.step.studies]
EACH = pytest.mark.parametrize(("found", "study"), STUDIED, ids=[f"{f.id}: {study.title[17:]}" for f, study in STUDIED])
UP = np.array([0.0, 0.0, 1.0])
L, V = (v / np.linalg.norm(v) for v in np.random.default_rng(9).normal(size=(2, 40, 3)) * (1, 1, 0.2) + (0, 0, 1.2))
OTHERS = {  # what another model with a study amounts to, or none on purpose
    "brdf_blinn_phong_as_wide": lambda: (twin("brdf_blinn_phong_as_wide")(UP, L, V, 0.2, 0.5, 30.0),
                                         twin("brdf_blinn_phong")(UP, L, V, 0.2, 0.5, twin("blinn_exponent")(30.0))),
    "brdf_cook_torrance_smith": lambda: (twin("brdf_cook_torrance_smith")(UP, L, V, 0.4, 0.1),
                                         twin("brdf_geometry")(UP, L, V, 0.4, 0.1, 3)),
    "brdf_gltf": lambda: (twin("brdf_gltf")(UP, L, V, 0.95, 0.5, 0.4), twin("brdf_file")(UP, L, V, 0.5, 0.4, 2, 0)),
    "brdf_paint": lambda: (twin("brdf_paint")(UP, L, V, 0, 0.15, 30.0),
                           0.85 * twin("brdf_lambert")(UP, L, V, 0.62) + twin("brdf_phong")(UP, L, V, 0.0, 0.15, 30.0)),
    "brdf_flawed": None,  # no BRDF at all is what it shows
}


def starting(prefix: str, *first: str) -> list[str]:
    """The twins of this name with these arguments; as printed and naive forms are errors, and those have their own."""
    return [name for name in names() if name.startswith(prefix) and arguments(name)[:len(first)] == first
            and not re.search("_(printed|naive)$", name)]


MODELS, FACETS = starting("brdf_", "n", "l", "v"), starting("d_", "n", "h")


def test_there_are_models_and_distributions():
    assert {"brdf_lambert", "brdf_oren_nayar", "brdf_coated", "brdf_ggx"} <= set(MODELS)
    assert {"d_gauss", "d_blinn_phong", "d_beckmann", "d_ggx"} <= set(FACETS)
    shown = {model.term.function for found in steps() for model in found.step.models}
    assert {name for name in shown if not name.endswith("_printed")} <= set(MODELS)


@pytest.mark.parametrize("name", MODELS)
def test_every_model_has_a_study(name):
    studied = {term.function for _, study in STUDIED for term in study.integrand}
    if name not in OTHERS:
        assert name in studied, f"lessons/studies.py has no study of {name}"
    elif OTHERS[name]:
        same, other = OTHERS[name]()
        assert name not in studied and np.max(same) > 0
        np.testing.assert_allclose(same, other, rtol=1e-12)


@pytest.mark.parametrize("name", FACETS)
def test_every_distribution_has_a_study_of_its_sum(name):
    """Some case of a study of int D cos sums exactly this D: it is the same at any h; and one of its cases is stiff."""
    widths = []
    for _, study in STUDIED:
        for _, given in cases(study) if study.over == "halfways" else ():
            m = given["m"]
            width = float(twin("exponent_from_m")(m)) if "exponent" in arguments(name) else m
            h = UP + m * np.random.default_rng(3).normal(size=(30, 3)) * (1, 1, 0)
            h /= np.linalg.norm(h, axis=-1, keepdims=True)
            if np.allclose(Integral(study, given).above(h), twin(name)(UP, h, width), rtol=1e-9):
                widths.append(m)
    assert max(widths) == 1 and min(widths) <= 0.01


def test_stiff_lobes_go_as_far_as_asked():
    exponents, widths = ([given[name] for _, study in STUDIED for _, given in cases(study) if name in given]
                         for name in ("exponent", "m"))
    assert max(exponents) == 1e7 and min(widths) == 1e-4
    assert float(twin("exponent_from_m")(4.472e-4)) == pytest.approx(1e7, rel=1e-3)  # the cosine lobe as a D


# --- methods ---------------------------------------------------------------------------------------------------------
KINDS = {"uniform": r"random uniform", "cosine": r"random cosine", "importance": r"random (importance|both)",
         "jittered": r"jittered ", "Sobol": r"sobol ", "Fibonacci": r"fibonacci ", "Gauss l": r"gauss angles",
         "Gauss h": r"gauss half", "Lebedev": r"lebedev", "adaptive": r"cubature ", "Gauss-Laguerre": r"laguerre ",
         "semi-analytic": r"semi-analytic|pieces"}


@EACH
def test_a_method_that_is_left_out_has_a_reason(found, study):
    """Of the integrals over directions; the others have lists of their own."""
    rules = [method.rule for method in study.methods]
    absent = {kind for kind, rule in KINDS.items() if not any(re.match(rule, one) for one in rules)}
    assert set(study.without) == (absent if study.over in ("directions", "halfways") and study.integrand[0].function
                                  != "meets_patch" else set())
    assert all(len(reason.split()) > 4 for reason in study.without.values())


# --- the exact value -------------------------------------------------------------------------------------------------
CUT = [(found, study) for found, study in STUDIED if study.over == "directions" and study.width != ""]


@pytest.mark.parametrize(("found", "study"), CUT, ids=[f"{f.id}: {s.title[17:]}" for f, s in CUT])
def test_the_rule_in_pieces_is_exact(found, study):
    """Against the closed or semi-analytic form where there is one, else against itself with more points."""
    base = {name: spec.default for name, spec in found.values.items()}
    exact = Method("", "pieces") if isinstance(study.exact, Method) else None
    for _, given in cases(study):
        for angle in worst(study):
            values = seen(base | given | angle)
            right = estimate(study, exact, values, 60, 0).value if exact else reference(study, values)
            assert estimate(study, Method("", "pieces"), values, 40, 0).value == pytest.approx(right, rel=1e-10), values
            assert estimate(study, Method("", "pieces"), values, 12, 0).value == pytest.approx(right, rel=1e-5), values


@pytest.mark.parametrize("kind", [1, 2, 3])
def test_the_rule_in_pieces_meets_what_others_found(kind):
    """The albedos of the lessons' own closed sums, which say "below 1e-5"."""
    study = step("geometry_term/with_without").step.studies[0]
    term = replace(study.integrand[0], args={"f0": 1.0, "geometry": kind})
    for m in (0.05, 0.3, 1.0):
        values = {"m": m, "theta_v": 1.1}
        found = estimate(replace(study, integrand=(term,)), Method("", "pieces"), values, 24, 0).value
        assert found == pytest.approx(float(twin("albedo_geometry")(1.1, m, kind)), rel=1e-5)


# --- silent failures -------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("m", "fails", "at"), [(0.1, False, ""), (0.01, False, ""), (3e-3, True, "80°"),
                                                (1e-3, True, ""), (1e-4, True, "")])
def test_the_adaptive_rule_fails_silently_below_some_width(m, fails, at):
    """One angle of three at which it gives up does not excuse those at which it says converged; however short the time
    is, the first rung is always climbed, and there it shows."""
    study = step("microfacets/cook_torrance").step.studies[0]
    only = replace(study, methods=tuple(one for one in study.methods if one.label == "adaptive l"))
    for budget in (0.0, 3.0):
        line, = measure(only, {"m": m, "f0": 1.0}, budget).lines
        assert bool(line.silent) is fails
        assert all(point.silent is fails for point in line.points)
        if fails:
            assert re.fullmatch(r"converged, but (50|100) % off at θv = (46|80)°", line.silent[0].words)
            assert at in line.silent[0].words
