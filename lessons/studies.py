"""What a digit costs: the studies of error against run time that steps carry, by the step's name.

`halfway study` measures them over their cases; in the window a step's studies are the last of its plots, and a click on
a point sets the step to that method and that number of samples. In the methods' names l stands for a rule over the
light's directions, h for one over the halfway vectors, D for samples drawn from the distribution of facets. What an
albedo's study leaves out of the course's methods it says, with the reason.
"""

from math import pi as PI

from app.lesson import Method, Study, Term

EVERYWHERE = {"theta_v": (0.0, 46.0, 80.0)}  # degrees; an error is the worst of these
WIDTHS = ({"m": 1.0}, {"m": 0.1}, {"m": 0.01}, {"m": 1e-4})
EXPONENTS = ({"exponent": 10.0}, {"exponent": 1000.0}, {"exponent": 1e5}, {"exponent": 1e7})
BLIND = (
    Method("random", "random uniform"),
    Method("random, cosine", "random cosine"),
    Method("Sobol", "sobol uniform"),
)
GRIDS = (
    Method("Gauss l", "gauss angles"),
    Method("Lebedev", "lebedev"),
    Method("adaptive l", "cubature angles"),
)
DRAWN = (
    Method("random D", "random importance"),
    Method("jittered D", "jittered importance"),
    Method("Sobol D", "sobol importance"),
    Method("Fibonacci D", "fibonacci importance"),
)
HALVES = (Method("Gauss h", "gauss half"), Method("adaptive h", "cubature half"))
LAGUERRE = Method("Gauss-Laguerre", "laguerre importance")
PIECES = Method("Gauss h, cut", "pieces")
NARROW = (*BLIND, *GRIDS, *DRAWN, *HALVES)
MATT = (Method("random", "random uniform"), Method("random, cosine", "random cosine"),
        Method("jittered, cosine", "jittered cosine"), Method("Sobol, cosine", "sobol cosine"),
        Method("Fibonacci, cosine", "fibonacci cosine"), *GRIDS)
EXACT = Method("exact", "pieces", ladder=(40,))  # a rule with so many points that nothing is left
BROAD = "a matt surface has no lobe to draw from or to stretch a rule to"
NO_LOBE = dict.fromkeys(("importance", "Gauss h", "Gauss-Laguerre", "semi-analytic"), BROAD)
TAILS = {"Gauss-Laguerre": "its weight e^(-t) is Beckmann's tail; GGX's is a power"}
BODY = {"Gauss-Laguerre": "the body under the mirror is no e^(-t) of the halfway vector"}
MIXED = tuple(Method(f"{one.label} + cos", one.rule.replace("importance", "both")) for one in DRAWN)
COATED = (*BLIND, *GRIDS, *MIXED, *HALVES, PIECES)
GIVES_ONE = "facets drawn from D weigh 1 each: the first gives the exact sum"


def counted(of: str) -> tuple[Method, ...]:
    """Rays that meet the square or not."""
    return (Method("random", f"random {of}"), Method("jittered", f"jittered {of}"), Method("Sobol", f"sobol {of}"),
            Method("Fibonacci", f"fibonacci {of}", sets={"samples": "N"} if of == "uniform" else {}))


def lit(name: str, kind: int) -> Method:
    return Method(name, term=Term("irradiance_light_sampled", {"sampling": kind}), cost="level")


STUDIES: dict[str, tuple[Study, ...]] = {
    "solid_angle/patch": (Study(
        "Cost of a digit: solid angle", Term("solid_angle_patch"),
        (*counted("uniform"), Method("as if small", term=Term("solid_angle_patch_small")),
         Method("closed form", term=Term("solid_angle_patch"))),
        why="A ray meets the square or it does not: counting pays for every digit with ten to a hundred times the rays, "
            "and for a small square nearly all miss. The closed form costs the same at every size.",
        over="sphere", integrand=(Term("meets_patch"),),
        cases=({"width": 1.2}, {"width": 0.2}, {"width": 0.05})),),
    "solid_angle/projected": (Study(
        "Cost of a digit: projected solid angle", Term("projected_solid_angle_patch"),
        (Method("random, even", "random uniform"), *counted("cosine"), Method("adaptive", "cubature angles"),
         Method("closed form", term=Term("projected_solid_angle_patch"))),
        why="Rays drawn by the cosine need no weight, which is Nusselt's drawing turned round. The square's edge is a "
            "step all the same, and only the closed form, a walk along the edge, is free of it.",
        over="directions", integrand=(Term("meets_patch", {"towards": "l"}),),
        cases=({"width": 1.2}, {"width": 0.2}, {"width": 0.05})),),
    "radiometry/eye": (Study(
        "Cost of a digit: lumens",
        Method("exact", "segments line", ladder=(80 * 16,)),
        (Method("random", "random line"), Method("jittered", "jittered line"), Method("midpoints", "middles line"),
         Method("Gauss", "gauss line"), Method("adaptive", "cubature line"), Method("Gauss, each 5 nm", "segments line")),
        why="V is a table, straight between its entries and bent at each: a rule for smooth functions stumbles over the "
            "bends. Cut there, and two Gauss points in each piece are nearly exact.",
        over="wavelengths", integrand=(Term("luminous_efficiency"), Term("planck_radiance")),
        cases=({"temperature": 2700.0}, {"temperature": 6500.0})),),
    "lights/ies": (Study(
        "Cost of a digit: luminaire's flux", Term("ies_flux"),
        (Method("random", "random uniform"), Method("jittered", "jittered uniform"), Method("Sobol", "sobol uniform"),
         Method("Fibonacci", "fibonacci uniform"), Method("Gauss", "gauss angles"), Method("adaptive", "cubature angles"),
         Method("piece by piece", term=Term("ies_flux"))),
        why="Between two measured angles the candela are a straight line, whose flux is known in closed form. A rule over "
            "the whole sphere does not know where the lines bend.",
        over="angles", integrand=(Term("ies_candela"),),
        cases=tuple({"luminaire": i} for i in range(4))),),
    "lights/area_work": (Study(
        "Cost of a digit: irradiance", Term("irradiance_light"),
        (lit("midpoints", 0), lit("random", 1), lit("stratified", 2), lit("Sobol", 3), lit("Sobol, angle", 4),
         lit("Gauss, angle", 5), Method("closed form", term=Term("irradiance_light"))),
        why="Even in solid angle the integrand is only a cosine, and Gauss points need few of a smooth one. The closed "
            "form still wins: one walk along the edge, whatever the digits.",
        cases=tuple({"light_shape": i} for i in range(4)), pixels="position"),),
    "brdfs/lambert": (Study(
        "Cost of a digit: Lambert's albedo", "rho",
        (*MATT, Method("tiles", "tiles angles", ladder=(1, 2, 3, 6, 12, 24, 96),
                       sets={"tile_rows": "rung", "half_angle": 0.5 * PI})),
        why="Drawn by the cosine every sample weighs the same: one is exact. Without it, the samples pay for a cosine that "
            "is known by heart; Gauss points see it whole, the scene's tiles see it bit by bit.",
        over="directions", integrand=(Term("brdf_lambert"),), eye="", without=NO_LOBE),),
    "brdfs/phong": (Study(
        "Cost of a digit: Phong's albedo", Term("albedo_phong"),
        (*BLIND, *GRIDS, *(Method(m.label.replace("D", "lobe"), m.rule) for m in DRAWN),
         Method("Gauss lobe", "gauss half"), Method("adaptive lobe", "cubature half"), LAGUERRE,
         Method("Gauss lobe, cut", "pieces")),
        why="Drawn from the lobe itself, nearly every sample counts the same: what is left is the cut at the horizon. "
            "Drawn blindly, nearly all of them miss a narrow lobe.",
        over="directions", integrand=(Term("brdf_phong", {"k_d": 0.0, "k_s": 1.0}),), sampler="blinn_phong",
        width=Term("m_from_exponent"), about="mirror", worst=EVERYWHERE,
        cases=EXPONENTS),),
    "brdfs/blinn_phong_brdf": (Study(
        "Cost of a digit: Blinn-Phong's albedo", Term("albedo_blinn_phong"), (*NARROW, LAGUERRE, PIECES),
        why="Gauss points in the halfway vector's own angles, stretched to the lobe, see the same smooth hill at every "
            "exponent. Over l the hill is a needle, and a rule that misses it does not know.",
        over="directions", integrand=(Term("brdf_blinn_phong", {"k_d": 0.0, "k_s": 1.0}),), sampler="blinn_phong",
        width=Term("m_from_exponent"), worst=EVERYWHERE,
        cases=EXPONENTS),),
    "microfacets/distribution": (Study(
        "Cost of a digit: sum of D cos a", 1.0,
        (*BLIND, Method("jittered", "jittered uniform"), Method("Fibonacci", "fibonacci cosine"),
         Method("rings", term=Term("facet_area", {"cosines": 1}), cost="rows",
                ladder=(4, 8, 16, 32, 64, 128, 512, 2048)),
         Method("Gauss, angle", "gauss angles"), Method("Lebedev", "lebedev"), Method("Gauss, slope", "gauss half"),
         Method("adaptive, angle", "cubature angles"), Method("adaptive, slope", "cubature half")),
        why="In tan a / m a narrow lobe is the same hill as a broad one, so one rule serves all, also an exponent of 10⁷. "
            "Over the angle it hides between the nodes, and an adaptive rule finds 0 and calls it converged.",
        over="halfways", integrand=(Term("d_at"),), width="m",
        without=dict.fromkeys(("importance", "Gauss-Laguerre", "semi-analytic"), GIVES_ONE),
        cases=(*({"ndf": 2, **case} for case in WIDTHS), {"ndf": 0, "m": 1.0}, {"ndf": 0, "m": 0.01},
               {"ndf": 1, "m": 1.0}, {"ndf": 1, "m": 4.472e-4}, {"ndf": 3, "m": 1.0}, {"ndf": 3, "m": 0.01},
               {"ndf": 3, "m": 1e-4})),),
    "microfacets/interreflections": (Study(
        "Cost of a digit: EON's albedo", Term("albedo_eon"), MATT,
        why="A matt lobe is broad: no point is wasted. Its one crease, at s = 0, holds Gauss points up after four digits; "
            "Sobol points, which no line upsets, are first in the last ones.",
        over="directions", integrand=(Term("brdf_eon"),), without=NO_LOBE, cases=({"theta_v": 60.0},)),
        Study(
        "Cost of a digit: Oren–Nayar's albedo", Term("albedo_oren_nayar"), MATT,
        why="max(0, s) bends across the whole hemisphere, and max(n·l, n·v) on a ring: Gauss points lose what makes them "
            "fast. Sobol points do not care where a line runs, and come as far.",
        over="directions", integrand=(Term("brdf_oren_nayar"),), without=NO_LOBE, cases=({"theta_v": 60.0},))),
    "microfacets/cook_torrance": (Study(
        "Cost of a digit: Cook-Torrance's albedo", Term("albedo_cook_torrance"),
        (*NARROW, LAGUERRE, Method("semi-analytic", "semi-analytic")),
        why="The semi-analytic way cuts the lobe where G bends and integrates around in closed form, so that the rest is "
            "smooth. Small m makes the drawn samples better and the blind ones useless.",
        over="directions", integrand=(Term("brdf_cook_torrance"),), sampler="beckmann", width="m", worst=EVERYWHERE,
        cases=WIDTHS),),
    "geometry_term/with_without": (Study(
        "Cost of a digit: albedo without G", EXACT, (*NARROW, LAGUERRE, PIECES),
        why="Without G no crease is left, and over l the horizon is the domain's own edge: Gauss points take the hill whole, "
            "steep as it is at 80°. A needle they miss; stretched to it, or drawn from D, a few points do.",
        over="directions", integrand=(Term("brdf_geometry", {"f0": 1.0, "geometry": 0}),), sampler="beckmann", width="m",
        worst=EVERYWHERE, cases=({"m": 0.5}, {"m": 0.01})),),
    "geometry_term/smith": (Study(
        "Cost of a digit: GGX's albedo", Term("albedo_ggx", {"alpha": "m", "f0": 1.0}),
        (*BLIND, *GRIDS, *DRAWN, Method("Gauss mirror", "gauss mirror"), *HALVES, PIECES),
        why="Smith's G has no crease, and over l the horizon is the edge of the domain itself: twice the Gauss points a "
            "side, twice the digits. Over h the horizon cuts through, and that is a step.",
        over="directions", integrand=(Term("brdf_ggx", {"alpha": "m", "f0": 1.0}),), sampler="ggx", width="m",
        without=TAILS, worst={"theta_v": (0.0, 46.0)}, cases=({"m": 1.0}, {"m": 0.5}, {"m": 0.1}, {"m": 0.01})),
        *(Study(
        f"Cost of a digit: Smith's {words} albedo", EXACT, (*NARROW, LAGUERRE, PIECES),
        why="A G without creases: while the lobe is broad Gauss points over l win, as for GGX. Across a narrow lobe G is "
            "all but constant, and what is left is e^(-t), which Gauss-Laguerre has for its weight.",
        over="directions", integrand=(Term("brdf_geometry", {"f0": 1.0, "geometry": kind}),), sampler="beckmann",
        width="m", worst=EVERYWHERE, cases=({"m": 0.5}, {"m": 0.01}))
          for kind, words in ((2, "separable"), (3, "correlated")))),
    "plausible_shading/compare": (Study(
        "Cost of a digit: a material's albedo", EXACT, COATED,
        why="Plastic is two lobes, a mirror's and a broad body's: drawn from both, a sample is never far from either. Gold "
            "has the mirror alone, and a rule that is stretched to it needs nothing else.",
        over="directions", integrand=(Term("brdf_matter", {"channel": 0}),), sampler="beckmann", width="m",
        eye="theta_d", without=BODY, worst={"theta_d": (0.0, 46.0, 80.0)},
        cases=({"material": 2, "m": 0.3}, {"material": 5, "m": 0.02})),
        Study(
        "Cost of a digit: Blinn-Phong's, of a material", EXACT, COATED,
        why="No G and no Fresnel at the rim: over l nothing bends, and Gauss points take both lobes whole. Over h the "
            "horizon cuts through the highlight, and a rule that is not cut there soon stops gaining.",
        over="directions", integrand=(Term("brdf_matter_blinn", {"channel": 0}),), sampler="beckmann", width="m",
        eye="theta_d", without=BODY, worst={"theta_d": (0.0, 46.0, 80.0)}, cases=({"material": 2, "m": 0.3},))),
    "plausible_shading/energy": (Study(
        "Cost of a digit: a coated body's albedo",
        (Term("albedo_cook_torrance", {"m": 0.02}), Term("albedo_body", {"coupling": 3})), COATED,
        why="The body is broad and the coat's mirror is a needle: blind points find the body and miss the mirror, and "
            "say nothing of it. Each drawn in its own way, both are there from the first samples.",
        over="directions", integrand=(Term("brdf_coated", {"coupling": 3, "m": 0.02}),), sampler="beckmann", width=0.02,
        without=BODY, worst=EVERYWHERE, cases=({"f0": 0.04},)),),
    "plausible_shading/board": (Study(
        "Cost of a digit: the board's albedo",
        (Term("albedo_cook_torrance"), Term("albedo_body", {"coupling": 3})), COATED,
        why="From a dull coat to a mirror the body stays and the highlight shrinks. Points that are drawn or cut for both "
            "need no more at any m; blind ones lose the highlight and keep their confidence.",
        over="directions", integrand=(Term("brdf_coated", {"coupling": 3}),), sampler="beckmann", width="m",
        without=BODY, worst=EVERYWHERE, cases=({"m": 0.3}, {"m": 0.01})),),
    "plausible_shading/second_opinion": (Study(
        "Cost of a digit: a file's albedo", EXACT, COATED,
        why="glTF's G is a fit without creases, but n·l stops at 0.001: a bend at the very horizon. Both lobes drawn, a "
            "thousand samples are enough for a picture; for digits the cut rule is.",
        over="directions", integrand=(Term("brdf_file", {"channel": 0}),), sampler="ggx", width=Term("alpha_gltf"),
        without=BODY, worst=EVERYWHERE, cases=({"mapped": 1, "roughness": 0.5}, {"mapped": 2, "roughness": 0.2})),),
}
