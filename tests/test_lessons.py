"""Every chapter, by being there: it loads, its scenes run, its steps are whole, its predictions have an answer."""

import math

import numpy as np
import pytest

from app import catalog, prediction, prose
from app.export.still import data
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.maps import NONE
from app.prediction import truth
from app.readouts import numbers
from app.state import defaults, parse_query
from app.stress.scenes import corners, played
from app.terms import evaluate
from app.theme import THEMES
from app.validation import validate

STEPS = catalog.steps()
SLIDES = [line for line in (catalog.LESSONS.parent / "tests/reference/deck_slides.txt").read_text("utf-8").splitlines()
          if line and not line.startswith("#")]
SIZE = (96, 96)
every_step = pytest.mark.parametrize("found", STEPS, ids=lambda found: found.id)


def sentences(text: str) -> int:
    """Full stops, question marks and colons do not count inside a formula or a number."""
    return sum(text.count(end) for end in (". ", "? ", "! ")) + 1


@pytest.mark.parametrize("loaded", catalog.chapters(), ids=lambda loaded: loaded.id)
def test_a_chapter_is_sound(loaded):
    assert validate(loaded, SLIDES) == []
    assert loaded.intro and loaded.chapter.title and sentences(loaded.chapter.idea) == 1 and loaded.chapter.exercises


@every_step
def test_a_step_has_all_of_a_step(found):
    """teaching.md, section 1."""
    step, values = found.step, found.values
    assert step.title and step.idea.endswith(".") and sentences(step.idea) == 1
    assert step.slides and step.sources and step.honesty and step.notes.strip() and 1 <= step.minutes <= 15
    controls = [name for name, value in values.items() if not value.more]
    assert 1 <= len(controls) <= 4, f"{len(controls)} controls are in view: {controls}"
    assert 2 <= len(step.readouts) <= 4
    assert 60 <= prose.words(step.prose) <= 150, f"{prose.words(step.prose)} words of prose"
    assert step.scene.surfaces and (step.scene.handles or not values), "nothing to take in the hand"
    assert any(link.sets_values for link in prose.links(step.prose)), "no button in the prose"
    assert step.ask.question.rstrip().endswith("?") and step.ask.told


@every_step
def test_a_links_state_is_a_state_of_the_step(found):
    """And it changes something, or leads back from where another link or a hand has led."""
    first = defaults(found)
    links = {link.words: parse_query(link.target.lstrip("?"), found)[0] for link in prose.links(found.step.prose)
             if link.sets_values}
    changed = {name for values in links.values() for name in values if values[name] != first[name]}
    changed |= {name for handle in found.step.scene.handles for name in handle.values}
    for words, values in links.items():
        assert set(values) <= set(found.values)
        assert set(values) & changed, f"[{words}] changes nothing"


@every_step
def test_a_prediction_has_one_answer(found):
    ask = found.step.ask
    values = prediction.truth_values(found)
    answer = truth(found, **data(found, values))
    assert math.isfinite(answer)
    if ask.choices:
        right = [choice.text for choice in ask.choices if choice.low <= answer <= choice.high]
        assert len(right) == 1, f"the truth is {answer}: {right} are right"
    else:
        assert ask.low < answer < ask.high, f"{answer} is outside the slider"
        assert ask.scale == "linear" or ask.low > 0


@every_step
def test_an_error_is_against_an_exact_number(found):
    labels = {r.label: r for r in found.step.readouts}
    assert len(labels) == len(found.step.readouts)
    for readout in found.step.readouts:
        if readout.against:
            exact = labels[readout.against]
            assert exact.role == "exact" and exact.precision == "float64" and readout.role in ("estimate", "printed")


@every_step
def test_every_number_of_a_step_is_a_number(found, ctx):
    for values in corners(found, 6):
        for number in numbers(found.step, {**values, **data(found, values)}, ctx):
            no_number = found.id in NO_NUMBER and NO_NUMBER[found.id](values)
            assert (math.isfinite(number.value) or no_number) and number.text, f"{number.label} at {values}"


NO_NUMBER = {  # a formula without a value is shown on purpose, and said in words
    "brdfs/properties": lambda values: values["flaw"] == 5 and 0 in (values["theta_l"], values["theta_v"]),
    "lights/area_units": lambda values: 0 in (values["panel_width"], values["panel_depth"]),
}


@every_step
def test_no_corner_of_the_sliders_has_a_fault(found, ctx):
    """NaN, Inf and negative radiance are shown in class, so a lesson may have none where it does not mean to."""
    assert played(found, ctx=ctx).faults == ()


@every_step
@pytest.mark.parametrize("theme", THEMES)
def test_a_step_is_interesting_before_anything_is_touched(found, theme, ctx):
    values = defaults(found)
    values |= data(found, values)
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    stage.draw(values, found.step.scene.camera, (192, 192), THEMES[theme])
    pixels = stage.picture.pixels().reshape(-1, 3)
    stage.release()
    colours, counts = np.unique(pixels // 16, axis=0, return_counts=True)
    assert counts.max() < 0.9 * counts.sum(), "the picture is nearly empty"
    assert len(colours) > 20, "the picture is nearly of one colour"


def test_phong_s_links_show_what_they_promise():
    """As printed: f grows beyond 1 in low light, and another f for light and eye swapped."""
    from app.optics import twin

    found = catalog.step("brdfs/phong")
    links = [link for link in prose.links(found.step.prose) if link.sets_values]
    at = {link.words: defaults(found) | parse_query(link.target[1:], found)[0] for link in links}
    f = twin("highlight_brdf")
    low, swap = at["low light"], at["swapping"]
    assert f(**low) > 5 * f(**defaults(found))
    assert f(**swap | {"theta_l": swap["theta_v"], "theta_v": swap["theta_l"]}) > 2 * f(**swap)


@pytest.mark.parametrize("agree", [False, True])
def test_a_crease_is_a_line_even_where_light_and_eye_agree(agree, ctx):
    """Masking and shadowing are then the same all over, and not a crease all over."""
    found = catalog.step("geometry_term/combined")
    values = defaults(found) | ({"theta_l": 1.2, "theta_v": 1.2, "phi": 0.0} if agree else {})
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), None)
    stage.draw(values, found.step.scene.camera, (256, 256), THEMES["dark"])
    pixels = stage.picture.pixels().reshape(-1, 3).astype(int)
    stage.release()
    white = np.mean(np.all(pixels > 225, axis=1))
    assert 0.002 < white < 0.05


UNDER_SKY = {"zenith_radiance": 1.0, "sun_radiance": 25.0, "k_d": 0.2, "k_s": 0.7, "exponent": 40.0}
PLATE = {"model": 1, "theta_l": math.radians(70), "theta_v": math.radians(40), "phi": math.pi, "k_d": 0.6, "k_s": 0.3,
         "exponent": 20.0}
SWAP = {"model": 0, "phi": 2.5, "k_d": 0.0, "k_s": 1.0, "exponent": 20.0}
TWO_METRES = {"light_shape": 0, "radiance": 10.0, "light_x": 0.0, "light_y": 0.0, "light_height": 0.5,
              "panel_width": 2.0, "panel_depth": 2.0, "panel_tilt": 0.0, "position": (0.0, 0.0, 0.0)}
WHITE = {"theta_v": math.radians(85), "rho": 1.0, "f0": 0.04}
QUOTED = [  # what the words of a lesson say, the twin that says it too, and how many digits are printed
    ("solid_angle/patch", "0.29, not 0.25", 0.29, 0.005, "solid_angle_patch_ratio",
     {"distance": 1.0, "tilt": 0.0, "width": 1.0}),
    ("solid_angle/cone", "About 185 000", 185_000, 500, "cones_in_the_sphere", {"half_angle": math.radians(0.2666)}),
    ("solid_angle/cone", "6.8e-5 sr", 6.8e-5, 5e-7, "solid_angle_cone", {"half_angle": math.radians(0.2666)}),
    ("solid_angle/cone", "of 12.57", 12.57, 0.005, "solid_angle_cone", {"half_angle": math.pi}),
    ("solid_angle/angle", "4π ≈ 12.57", 12.57, 0.005, "solid_angle_cone", {"half_angle": math.pi}),
    ("solid_angle/angle", "[one steradian](?half_angle=32.77)", 1.0, 5e-4, "solid_angle_cone",
     {"half_angle": math.radians(32.77)}),
    ("solid_angle/mesh", "10.3 sr", 10.3, 0.05, "sphere_less_cone", {"half_angle": math.radians(50)}),
    ("solid_angle/mesh", "= 2.24", 2.24, 0.005, "solid_angle_cone", {"half_angle": math.radians(50)}),
    ("solid_angle/projected", "It takes 0.33 sr", 0.33, 0.005, "solid_angle_patch",
     {"distance": 2.0, "tilt": 0.0, "width": 1.2}),
    ("solid_angle/projected", "About 0.02 sr", 0.02, 0.005, "projected_solid_angle_patch",
     {"theta": math.pi / 2, "distance": 2.0, "tilt": 0.0, "width": 1.2}),
    ("radiometry/energy_flux", "60 000 W", 60_000, 1, "radiant_flux_mean", {"radiant_energy": 60.0, "duration": 0.001}),
    ("radiometry/radiant_intensity", "= 0.80 W/sr", 0.80, 0.005, "radiant_intensity_isotropic", {"radiant_flux": 10.0}),
    ("radiometry/irradiance", "π = 3.14", 3.14, 0.005, "irradiance_cap", {"radiance": 1.0, "half_angle": math.pi / 2}),
    ("radiometry/radiosity", "400/π = 127", 127, 0.5, "radiance_lambert", {"rho": 0.8, "irradiance": 500.0}),
    ("radiometry/radiosity", "400/2π = 64", 64, 0.5, "radiance_lambert_over_hemisphere",
     {"rho": 0.8, "irradiance": 500.0}),
    ("radiometry/inverse_square", "[at five diameters](?radius=0.3&distance=3) the excess is one percent", 0.01, 1e-12,
     "inverse_square_excess", {"radius": 0.3, "distance": 3.0}),
    ("radiometry/inverse_square", "[half a diameter](?radius=0.7&distance=0.7) it is a hundred", 1.0, 1e-12,
     "inverse_square_excess", {"radius": 0.7, "distance": 0.7}),
    ("radiometry/local_only", "Five: 1 + 0.8", 5, 1e-12, "interreflection_gain", {"rho": 0.8}),
    ("radiometry/ledger", "3000 lm / 4π sr = 239 cd", 239, 0.5, "bulb_luminous_intensity",
     {"electrical_power": 100.0, "source_efficacy": 30.0}),
    ("radiometry/ledger", "gets 38.2 lx", 38.2, 0.05, "bulb_illuminance",
     {"electrical_power": 100.0, "source_efficacy": 30.0, "distance": 2.5}),
    ("radiometry/eye", "95 lm/W, never more", 95, 0.5, "luminous_efficacy_planck", {"temperature": 6600.0}),
    ("radiometry/eye", "from 400 to 700 nm: 251", 251, 0.5, "luminous_efficacy_band",
     {"temperature": 5800.0, "wavelength_low": 400.0, "wavelength_high": 700.0}),
    ("radiometry/eye", "its light worth 330", 330, 10, "luminous_efficacy_lamp", {"lamp": 1, "temperature": 3000.0}),
    ("lights/sources", "100: the area is a hundredth", 100, 1e-9, "radiance_sphere",
     {"radiant_flux": 4 * math.pi**2, "radius": 0.1}),
    ("lights/positional", "100. At 1 cm 10 000", 10_000, 1e-6, "irradiance_positional",
     {"radiant_intensity": 1.0, "distance": 0.01, "theta": 0.0, "source_radius": 0.001}),
    ("lights/positional", "at 1 m it already gives half", 0.5, 1e-3, "windowed_falloff",
     {"distance": 1.0, "reach": 10.0}),
    ("lights/directional", "0.20: a fifth", 0.2, 0.005, "falloff_error", {"distance": 5.0, "offset": 2.0}),
    ("lights/directional", "to 21 digits", 4e-22, 3e-23, "falloff_error", {"distance": 1.496e11, "offset": 2.5}),
    ("lights/distribution", "2.5 W/sr", 2.5, 1e-12, "radiant_intensity_of",
     {"radiant_flux": math.pi, "distribution": 2, "exponent": 4.0, "theta": 0.0}),
    ("lights/spot", "100 W/sr: 61 W", 61, 0.5, "spot_flux",
     {"radiant_intensity": 100.0, "hotspot": math.radians(20), "falloff": math.radians(30)}),
    ("lights/spot", "15.5 W: a quarter", 15.5, 0.05, "spot_flux",
     {"radiant_intensity": 100.0, "hotspot": math.radians(10), "falloff": math.radians(15)}),
    ("lights/area_units", "31.8: each square metre", 31.8, 0.05, "light_radiance",
     {"given": 0, "amount": 50.0, "light_shape": 0, "panel_width": 1.0, "panel_depth": 0.5}),
    ("lights/area_sampled", "gets 26 W/m²", 26, 0.5, "irradiance_light", TWO_METRES),
    ("lights/area_sampled", "160, six times too much", 160, 1e-9, "irradiance_light_sampled",
     TWO_METRES | {"sampling": 0, "level": 0, "seed": 0}),
    ("lights/area_sampled", "26 becomes 37 W/m²", 37, 0.5, "irradiance_light_without_cosine",
     TWO_METRES | {"level": 6}),
    ("lights/area_exact", "gives 0.79 W/m²", 0.79, 0.005, "irradiance_sphere_light",
     {"radiance": 1.0, "radius": 0.5, "distance": 1.0, "theta": 0.0}),
    ("lights/area_exact", "0.091", 0.091, 5e-4, "irradiance_sphere_light",
     {"radiance": 1.0, "radius": 0.5, "distance": 1.0, "theta": math.pi / 2}),
    ("lights/area_work", "26.5, or 1.5 % too much", 26.5, 0.05, "irradiance_light_sampled",
     TWO_METRES | {"sampling": 5, "level": 1, "seed": 0}),
    ("brdfs/balance", "70 W/m²", 70, 1e-12, "exitance_leaving",
     {"k_d": 0.5, "k_s": 0.2, "irradiance_facing": 100.0, "theta_l": 0.0}),
    ("brdfs/reflectance_equation", "gives 0.03 of it", 0.03, 0.005, "sun_share",
     UNDER_SKY | {"theta_l": math.radians(80), "phi": math.radians(90), "theta_v": math.radians(30)}),
    ("brdfs/reflectance_equation", "0.84 of the light", 0.84, 0.005, "sun_share",
     UNDER_SKY | {"theta_l": math.radians(55), "phi": math.pi, "theta_v": math.radians(55)}),
    ("brdfs/definition", "1.65 per steradian", 1.65, 0.005, "brdf_paint",
     {"n": (0, 0, 1), "l": (-0.6, 0, 0.8), "v": (0.6, 0, 0.8), "channel": 0, "k_s": 0.15, "exponent": 60.0}),
    ("brdfs/properties", "here has 1.51", 1.51, 0.005, "hemisphere_meter",
     {"theta_v": math.radians(22), "radiance": 1.0, "flaw": 0, "k_d": 0.6, "k_s": 0.3, "exponent": 20.0, "weight": 0}),
    ("brdfs/properties", "f = 1/π, gives 2 without", 2, 1e-12, "hemisphere_meter",
     {"theta_v": 0.0, "radiance": 1.0, "flaw": 0, "k_d": 1.0, "k_s": 0.0, "exponent": 20.0, "weight": 0}),
    ("brdfs/properties", "its radiance is 0.086", 0.086, 5e-4, "highlight_share", PLATE),
    ("brdfs/properties", "More: 0.19", 0.19, 0.005, "highlight_share",
     PLATE | {"theta_l": PLATE["theta_v"], "theta_v": PLATE["theta_l"]}),
    ("brdfs/properties", "f is 0.25 both ways", 0.25, 5e-4, "highlight_brdf", PLATE),
    ("brdfs/lambert", "π sin² 60°", 0.75 * math.pi, 1e-12, "projected_solid_angle_cone", {"half_angle": math.pi / 3}),
    ("brdfs/lambert", "is half of the sky: π", math.pi, 1e-12, "solid_angle_cone", {"half_angle": math.pi / 3}),
    ("brdfs/lambert", "The dome has $2\\pi$", 2 * math.pi, 1e-12, "solid_angle_cone", {"half_angle": math.pi / 2}),
    ("brdfs/phong", "2.23: more than twice", 2.23, 0.005, "highlight_flux",
     {"model": 0, "theta_l": math.radians(85), "k_d": 0.0, "k_s": 1.0, "exponent": 5.0}),
    ("brdfs/phong", "1.2e-5 against", 1.2e-5, 5e-7, "highlight_brdf", SWAP | {"theta_l": 0.3, "theta_v": 1.2}),
    ("brdfs/phong", "against 3.2e-5", 3.2e-5, 5e-7, "highlight_brdf", SWAP | {"theta_l": 1.2, "theta_v": 0.3}),
    ("brdfs/blinn", "26°. Up and down", math.radians(26), math.radians(0.5), "halfway_angle",
     {"theta_l": math.radians(80), "theta_v": math.radians(80), "phi": math.radians(170)}),
    ("brdfs/blinn", "turns half as far as the eye; aside", math.radians(5), 1e-12, "halfway_angle",
     {"theta_l": math.radians(80), "theta_v": math.radians(70), "phi": math.pi}),
    ("brdfs/blinn", "5.8 times as long as wide: 1/cos 80°", 5.8, 0.05, "highlight_stretch",
     {"theta_v": math.radians(80)}),
    ("brdfs/normalisation", "[exponent 5](?exponent=5&k_s=1) gives twice", 2.0, 0.1, "lobe_flux_blinn",
     {"theta_v": 0.0, "exponent": 5.0}),
    ("brdfs/normalisation", "a fortieth", 1 / 40, 1e-4, "lobe_flux_blinn", {"theta_v": 0.0, "exponent": 1000.0}),
    ("brdfs/normalisation", "sends back 1.5 times", 1.5, 0.05, "lobe_flux_blinn", {"theta_v": 0.0, "exponent": 10.0}),
    ("brdfs/normalisation", "0.24. The peak stayed", 0.24, 0.005, "lobe_flux_blinn",
     {"theta_v": 0.0, "exponent": 100.0}),
    ("brdfs/blinn_phong_brdf", "0.515. Nothing", 0.515, 5e-4, "albedo_blinn_phong",
     {"theta_v": math.pi / 3, "exponent": 5.0}),
    ("brdfs/blinn_phong_brdf", "At exponent 100 it is 0.265", 0.265, 5e-4, "albedo_blinn_phong",
     {"theta_v": math.pi / 3, "exponent": 100.0}),
    ("brdfs/blinn_phong_brdf", "3.14 at exponent 0", 3.14, 0.005, "lobe_flux_blinn", {"theta_v": 0.0, "exponent": 0.0}),
    ("brdfs/why_physical", "1.3 times the light", 1.3, 1e-12, "complaint_model", {"complaint": 0, "theta": 0.0}),
    ("brdfs/why_physical", "from 0.04 to 1", 0.04, 5e-4, "complaint_truth", {"complaint": 1, "theta": 0.0}),
    ("brdfs/why_physical", "0.37 of the blue", 0.37, 0.005, "complaint_truth", {"complaint": 2, "theta": 0.0}),
    ("brdfs/why_physical", "0.75, and all of it at 90°", 0.75, 0.005, "complaint_truth",
     {"complaint": 2, "theta": math.radians(85)}),
    ("microfacets/grooves", "6.9 cm", 6.9, 0.05, "resolved_distance", {"groove_width": 20.0}),
    ("microfacets/facets", "one in 300", 10000 / 300, 2, "facets_lit",
     {"theta_l": 0.0, "theta_v": 0.0, "phi": math.pi, "m": 0.3, "half_angle": math.radians(1), "facets": 10000}),
    ("microfacets/blocking", "0.42: the line", 0.42, 0.005, "groove_open",
     {"facet": math.radians(45), "lean_l": 0.0, "lean_v": math.radians(75)}),
    ("microfacets/interreflections", "0.82: nearly flat", 0.82, 0.005, "rim_oren_nayar",
     {"disk_x": 0.94, "phase": 0.0, "sigma": math.radians(40)}),
    ("microfacets/interreflections", "1.015 of the light", 1.015, 5e-4, "albedo_oren_nayar",
     {"n_dot_v": 0.0, "rho": 1.0, "sigma": 0.2}),
    ("microfacets/interreflections", "it has 0.34 of the radiance", 0.34, 0.005, "disk_lambert",
     {"disk_x": 0.94, "phase": 0.0, "rho": 1.0}),
    ("microfacets/cook_torrance", "0.45. The rest", 0.45, 0.005, "albedo_cook_torrance",
     {"theta_v": 0.0, "m": 1.0, "f0": 1.0}),
    ("microfacets/cook_torrance", "gives 1.27 as printed", 1.27, 0.005, "albedo_cook_torrance_printed",
     {"theta_v": 0.0, "m": 0.1, "f0": 1.0}),
    ("microfacets/cook_torrance", "1.000 with 1/4", 1.0, 5e-4, "albedo_cook_torrance",
     {"theta_v": 0.0, "m": 0.1, "f0": 1.0}),
    ("microfacets/distribution", "31.8 per steradian", 31.8, 0.05, "d_at", {"ndf": 2, "theta_h": 0.0, "m": 0.1}),
    ("microfacets/distribution", "(m = 0.408) only 0.349", 0.349, 5e-4, "facet_area_of_lobe", {"m": 0.408}),
    ("microfacets/beckmann", "8. The whole highlight", 8, 0.5, "cosine_steps", {"slope_ratio": 1.0, "m": 0.001}),
    ("microfacets/beckmann", "it turns 1.51", 1.51, 0.005, "d_at", {"ndf": 2, "theta_h": math.radians(10), "m": 0.1}),
    ("microfacets/beckmann", "into 758", 758, 0.5, "d_beckmann_printed", {"theta_h": math.radians(10), "m": 0.1}),
    ("microfacets/beckmann_only", "198. A tenth", 198, 1e-6, "exponent_from_m", {"m": 0.1}),
    ("microfacets/beckmann_only", "would be 19998", 19998, 1e-6, "exponent_from_m", {"m": 0.01}),
    ("microfacets/beckmann_only", "[8](?m=0.4472)", 8, 0.01, "exponent_from_m", {"m": 0.4472}),
    ("microfacets/beckmann_only", "[98](?m=0.1414)", 98, 0.1, "exponent_from_m", {"m": 0.1414}),
    ("microfacets/beckmann_only", "[998](?m=0.04472)", 998, 1, "exponent_from_m", {"m": 0.04472}),
    ("microfacets/beckmann_only", "(310, 100,", 310, 1, "exponent_from_m", {"m": 0.08}),
    ("microfacets/beckmann_only", "30, 8, 1)", 8, 0.5, "exponent_from_m", {"m": 0.45}),
    ("fresnel/flat_mirror", "0.04: four per cent", 0.04, 1e-12, "reflected_share", {"theta": 0.0, "eta": 1.5}),
    ("fresnel/angle", "83.5°: almost", 83.5, 0.05, "angle_of_half", {"eta": 1.333}),
    ("fresnel/angle", "60° it is still 6 %", 0.06, 0.005, "reflected_share",
     {"theta": math.pi / 3, "eta": 1.333}),
    ("fresnel/angle", "[Brewster](?theta=53.1)", math.radians(53.1), 1e-3, "brewster_angle", {"eta": 1.333}),
    ("fresnel/inside", "0.87; glass", 0.87, 0.005, "f_average_dielectric", {"eta": 0.4137}),
    ("fresnel/inside", "glass keeps 0.60", 0.60, 0.005, "f_average_dielectric", {"eta": 1 / 1.5}),
    ("fresnel/inside", "diamond sends back 0.21", 0.21, 0.005, "f_average_dielectric", {"eta": 2.4175}),
    ("fresnel/inside", "it is 41.8° for glass", math.radians(41.8), 1e-3, "critical_angle", {"eta": 1 / 1.5}),
    ("fresnel/inside", "rays within 24° get out", math.radians(24), 0.01, "critical_angle", {"eta": 0.4137}),
    ("fresnel/materials", "0.172. Silver", 0.172, 5e-4, "material_share", {"theta": 0.0, "material": 4, "channel": 1}),
    ("fresnel/materials", "Silver does 0.98", 0.98, 0.005, "material_share",
     {"theta": 0.0, "material": 6, "channel": 1}),
    ("fresnel/materials", "17 % and 51 %", 0.51, 0.005, "material_share", {"theta": 0.0, "material": 8, "channel": 1}),
    ("fresnel/metals", "[1.03](?material=gold", 1.03, 0.005, "material_share",
     {"theta": 0.0, "material": 5, "channel": 0}),
    ("fresnel/metals", "0.37 from the measured", 0.37, 0.005, "material_share",
     {"theta": 0.0, "material": 5, "channel": 2}),
    ("fresnel/dielectrics", "2.40; measured", 2.40, 0.005, "eta_from_f0", {"f0": 0.17}),
    ("fresnel/dielectrics", "and is 0.19", 0.19, 0.005, "material_srgb_of_printed", {"material": 1, "channel": 0}),
    ("fresnel/dielectrics", "0.21 for 0.190", 0.190, 5e-4, "material_srgb_of_printed", {"material": 1, "channel": 0}),
    ("fresnel/dielectrics", "is printed as 0.21", 0.21, 1e-12, "material_srgb_printed", {"material": 1, "channel": 0}),
    ("fresnel/schlick", "0.18, near 83°", 0.18, 0.005, "schlick_worst", {"material": 8}),
    ("fresnel/schlick", "For silver it is 0.007", 0.007, 5e-4, "schlick_worst", {"material": 6}),
    ("geometry_term/why", "2.15 times", 2.15, 0.005, "albedo_without_g", {"theta_v": math.radians(85), "m": 0.5}),
    ("geometry_term/why", "With G it is 0.98", 0.98, 0.005, "albedo_cook_torrance",
     {"theta_v": math.radians(85), "m": 0.5, "f0": 1.0}),
    ("geometry_term/masking", "from straight above: 2", 2.0, 1e-12, "groove_intercept_printed",
     {"facet": 0.7, "lean_v": 0.0}),
    ("geometry_term/masking", "0.42. The line of sight", 0.42, 0.005, "groove_open",
     {"facet": math.pi / 4, "lean_l": math.radians(75), "lean_v": math.radians(75)}),
    ("geometry_term/shadowing", "Of each facing side 0.42 is lit and seen", 0.42, 0.005, "groove_open",
     {"facet": math.pi / 4, "lean_l": math.radians(75), "lean_v": math.radians(30)}),
    ("geometry_term/combined", "0.13: 2 cos² 75°", 2 * math.cos(math.radians(75)) ** 2, 1e-12, "vgroove_at",
     {"theta_l": math.radians(75), "theta_v": math.radians(75), "phi": 0.0}),
    ("geometry_term/combined", "Up to 45° nothing is lost", 1.0, 1e-12, "vgroove_at",
     {"theta_l": math.pi / 4, "theta_v": math.pi / 4, "phi": 0.0}),
    ("geometry_term/with_without", "1.53 times what it gets", 1.53, 0.005, "albedo_without_g",
     {"theta_v": math.radians(85), "m": 0.3}),
    ("geometry_term/with_without", "3.73 times. G keeps", 3.73, 0.005, "albedo_without_g",
     {"theta_v": math.radians(85), "m": 1.0}),
    ("geometry_term/with_without", "G keeps 0.97", 0.97, 0.005, "albedo_cook_torrance",
     {"theta_v": math.radians(85), "m": 1.0, "f0": 1.0}),
    ("geometry_term/smith", "every good $G_1$ gives **1**", 1.0, 1e-6, "weak_furnace",
     {"theta_v": math.radians(80), "m": 1.0, "geometry": 3}),
    ("geometry_term/smith", "0.906. The test counts", 0.906, 5e-4, "albedo_smith",
     {"theta_v": math.radians(85), "m": 1.0, "geometry": 2}),
    ("geometry_term/smith", "Heights keep 0.959", 0.959, 5e-4, "albedo_smith",
     {"theta_v": math.radians(85), "m": 1.0, "geometry": 3}),
    ("geometry_term/smith", "V-grooves 0.969", 0.969, 6e-4, "albedo_cook_torrance",
     {"theta_v": math.radians(85), "m": 1.0, "f0": 1.0}),
    ("plausible_shading/board", "7.0 times. D and G", 7.0, 0.05, "mirror_gain", {"theta": math.pi / 3, "f0": 0.04}),
    ("plausible_shading/scale", "this one evaluation misses 2 %", 0.02, 0.005, "filter_error",
     {"m": 0.1, "bump_slope": 0.2}),
    ("plausible_shading/scale", "random places need 12 000", 12_000, 500, "samples_worth",
     {"m": 0.1, "bump_slope": 0.2}),
    ("plausible_shading/scale", "give D = 3.60 in the middle", 3.60, 0.005, "d_bumps", {"m": 0.1, "bump_slope": 0.2}),
    ("plausible_shading/scale", "forgotten bumps 31.8", 31.8, 0.05, "d_unfiltered", {"theta_h": 0.0, "m": 0.1}),
    ("plausible_shading/scale", "Toksvig 4.08", 4.08, 0.005, "d_toksvig",
     {"theta_h": 0.0, "m": 0.1, "bump_slope": 0.2}),
    ("plausible_shading/scale", "m_eff 3.54", 3.54, 0.005, "d_filtered",
     {"theta_h": 0.0, "m": 0.1, "bump_slope": 0.2}),
    ("plausible_shading/texturing", "0.5 is decoded to 0.21", 0.21, 0.005, "srgb_to_linear", {"encoded": 0.5}),
    ("plausible_shading/texturing", "5.5 times", 5.46, 0.005, "peak_gain_at",
     {"roughness_map": NONE, "map_s": 0.3560, "map_t": 0.55}),
    ("plausible_shading/texturing", "5.5 times: 0.5", 5.5, 0.05, "peak_gain", {"encoded": 0.5}),
    ("plausible_shading/compare", "20 times. The mirror's", 20, 0.5, "gain_cook_torrance",
     {"theta_d": math.radians(75), "material": 2, "channel": 0}),
    ("plausible_shading/compare", "from 0.05 to 0.27", 0.27, 0.005, "material_share",
     {"theta": math.radians(75), "material": 2, "channel": 0}),
    ("plausible_shading/compare", "Blinn-Phong: a quarter", 0.25, 0.01, "gain_blinn_phong",
     {"theta_d": math.radians(75)}),
    ("plausible_shading/quantities", "188. Half the light", 188, 0.5, "card_stored",
     {"luminous_flux": 400.0, "distance": 0.8, "rho": 0.8, "ev100": 4.4, "curve": 0}),
    ("plausible_shading/quantities", "of 800 lm just fills the sensor", 1.0, 5e-4, "card_exposed",
     {"luminous_flux": 800.0, "distance": 0.8, "rho": 0.8, "ev100": 4.4}),
    ("plausible_shading/measuring", "31.8 times", 31.8, 0.05, "luminance_over_inverse_square",
     {"source_radius": 0.1, "distance": 1.0}),
    ("plausible_shading/measuring", "250 lm win against 600", 20, 0.5, "lamp_illuminance",
     {"globe": 2, "luminous_flux": 800.0, "from_wall": 2.0, "along_wall": 0.7}),
    ("plausible_shading/energy", "1.563 times", 1.563, 5e-4, "albedo_coated", WHITE | {"coupling": 2}),
    ("plausible_shading/energy", "it is 1.648", 1.648, 5e-4, "albedo_coated", WHITE | {"coupling": 0}),
    ("plausible_shading/energy", "1 − F(l·h) 1.588", 1.588, 5e-4, "albedo_coated", WHITE | {"coupling": 1}),
    ("plausible_shading/energy", "In and out: 1.000", 1.0, 5e-4, "albedo_coated", WHITE | {"coupling": 3}),
    ("plausible_shading/energy", "mirrors 0.65", 0.65, 0.005, "f_schlick",
     {"l_dot_h": math.cos(math.radians(85)), "f0": 0.04}),
    ("plausible_shading/energy", "leave it 0.91 and more", 0.91, 0.005, "albedo_body", WHITE | {"coupling": 2}),
    ("plausible_shading/energy", "1.9 times the light", 1.9, 0.01, "albedo_coated",
     {"theta_v": 0.0, "rho": 1.0, "f0": 0.9, "coupling": 0}),
]


@pytest.mark.parametrize("quoted", QUOTED, ids=lambda quoted: f"{quoted[0]}: {quoted[1]}")
def test_a_number_in_the_words_is_the_twins(quoted):
    id, words, value, digits, function, args = quoted
    step = catalog.step(id).step
    text = " ".join((step.prose, step.ask.question, step.ask.told, step.notes, step.honesty))
    assert words in " ".join(text.split()), f"{id} no longer says {words!r}: change the list too"
    from app.optics import twin

    assert abs(float(twin(function)(**args)) - value) <= digits


def test_the_words_about_sums_and_steps_are_true():
    from app.optics import twin

    cells = twin("solid_angle_cells")
    notes = " ".join(catalog.step("solid_angle/differential").step.notes.split())
    assert f"{100 * (cells(4) / (4 * math.pi) - 1):.1f} % too large" in notes
    assert cells(8) / cells(4) < 1 and (cells(4) - 4 * math.pi) / (cells(8) - 4 * math.pi) == pytest.approx(4, rel=0.03)
    small, half = (twin("solid_angle_cone")(np.array([0.2, 0.1])))
    assert small / half == pytest.approx(4, rel=0.01), "half the angle, a quarter of the directions"
    near = {"distance": 0.5, "tilt": 0.0, "width": 2.0}
    assert twin("solid_angle_patch_small")(**near) / twin("solid_angle_patch")(**near) - 1 > 0.5


SECOND = [  # an exact readout and a second way to it: counting, the float32 twin, or the other formula
    ("solid_angle/patch", "solid_angle_patch", "solid_angle_patch_counted", {"samples": 60000}, 3e-3),
    ("solid_angle/cone", "solid_angle_cone", "solid_angle_cone_naive", {}, 1e-6),
    ("solid_angle/differential", "grid_cell", "grid_cell_differential", {"rows": 5000}, 1e-6),
    ("brdfs/lambert", "projected_solid_angle_cone", "cosine_sum", {"tile_rows": 3000}, 1e-6),
    ("radiometry/radiance", "radiance_sensor_projected", "radiance_sensor", {"half_angle": 1e-3}, 1e-6),
    ("radiometry/inverse_square", "irradiance_sphere", "irradiance_round_far", {"theta": 0.0}, 1e-12),
    ("brdfs/blinn", "blinn_exponent", "blinn_exponent_short", {"exponent": 1000.0}, 2e-4),
    ("microfacets/facets", "d_halfway", "d_near", {}, 0.03),
    ("microfacets/blocking", "groove_open", "groove_open_counted", {"samples": 4096}, 1e-3),
    ("geometry_term/masking", "groove_masking", "groove_open_counted",
     {"samples": 20000, "lean_l": math.radians(62)}, 2e-4),
    ("geometry_term/masking", "groove_masking", "groove_intercept_printed", {}, 1e-12),
    ("geometry_term/shadowing", "groove_open", "groove_open_counted", {"samples": 20000}, 2e-4),
    ("geometry_term/why", "albedo_without_g", "weak_furnace", {"m": 0.01, "theta_v": 1.2, "geometry": 1}, 1e-6),
    ("plausible_shading/measuring", "lamps_illuminance", "lamps_illuminance_by_area", {}, 1e-12),
]


@pytest.mark.parametrize("second", SECOND, ids=lambda second: f"{second[1]} = {second[2]}")
def test_an_exact_number_by_a_second_method(second):
    from app.lesson import Term

    id, exact, other, changes, close = second
    values = defaults(catalog.step(id)) | changes
    assert float(evaluate(Term(other), values)) == pytest.approx(float(evaluate(Term(exact), values)), rel=close)


@every_step
def test_float64_and_the_gpu_agree(found, ctx):
    """What the desktop shows and what the page will: the exact readouts in both arithmetics, to seven digits or so."""
    values = defaults(found)
    values |= data(found, values)
    for readout in found.step.readouts:
        if readout.role == "exact":
            desktop, page = (float(evaluate(readout.term, values, name, ctx)) for name in ("float64", "float32"))
            assert page == pytest.approx(desktop, rel=2e-6, abs=2e-6)
