"""What a digit costs: the studies of error against run time that steps carry, by the step's name.

`halfway study` measures them over their cases; in the window a step's study is the last of its plots, and a click on a
point sets the step to that method and that number of samples. In the methods' names l stands for a rule over the light's
directions, h for one over the halfway vectors, D for samples drawn from the distribution of facets.
"""

from app.lesson import Method, Study, Term

EVERYWHERE = {"theta_v": (0.0, 46.0, 80.0)}  # degrees; an error is the worst of these
WIDTHS = ({"m": 1.0}, {"m": 0.1}, {"m": 0.01}, {"m": 1e-4})
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
SMOOTH = (*BLIND, Method("Fibonacci, cosine", "fibonacci cosine"), Method("Gauss l", "gauss angles"),
          Method("Lebedev", "lebedev"), Method("adaptive l", "cubature angles"))


def counted(of: str) -> tuple[Method, ...]:
    """Rays that meet the square or not."""
    return (Method("random", f"random {of}"), Method("jittered", f"jittered {of}"), Method("Sobol", f"sobol {of}"),
            Method("Fibonacci", f"fibonacci {of}", sets={"samples": "N"} if of == "uniform" else {}))


def lit(name: str, kind: int) -> Method:
    return Method(name, term=Term("irradiance_light_sampled", {"sampling": kind}), cost="level")


STUDIES = {
    "solid_angle/patch": Study(
        "Cost of a digit: solid angle", Term("solid_angle_patch"),
        (*counted("uniform"), Method("as if small", term=Term("solid_angle_patch_small")),
         Method("closed form", term=Term("solid_angle_patch"))),
        why="A ray meets the square or it does not: counting pays for every digit with ten to a hundred times the rays, "
            "and for a small square nearly all miss. The closed form costs the same at every size.",
        over="sphere", integrand=(Term("meets_patch"),),
        cases=({"width": 1.2}, {"width": 0.2}, {"width": 0.05})),
    "solid_angle/projected": Study(
        "Cost of a digit: projected solid angle", Term("projected_solid_angle_patch"),
        (Method("random, even", "random uniform"), *counted("cosine"), Method("adaptive", "cubature angles"),
         Method("closed form", term=Term("projected_solid_angle_patch"))),
        why="Rays drawn by the cosine need no weight, which is Nusselt's drawing turned round. The square's edge is a "
            "step all the same, and only the closed form, a walk along the edge, is free of it.",
        over="directions", integrand=(Term("meets_patch", {"towards": "l"}),),
        cases=({"width": 1.2}, {"width": 0.2}, {"width": 0.05})),
    "radiometry/eye": Study(
        "Cost of a digit: lumens",
        Method("exact", "segments line", ladder=(80 * 16,)),
        (Method("random", "random line"), Method("jittered", "jittered line"), Method("midpoints", "middles line"),
         Method("Gauss", "gauss line"), Method("adaptive", "cubature line"), Method("Gauss, each 5 nm", "segments line")),
        why="V is a table, straight between its entries and bent at each: a rule for smooth functions stumbles over the "
            "bends. Cut there, and two Gauss points in each piece are nearly exact.",
        over="wavelengths", integrand=(Term("luminous_efficiency"), Term("planck_radiance")),
        cases=({"temperature": 2700.0}, {"temperature": 6500.0})),
    "lights/ies": Study(
        "Cost of a digit: luminaire's flux", Term("ies_flux"),
        (Method("random", "random uniform"), Method("jittered", "jittered uniform"), Method("Sobol", "sobol uniform"),
         Method("Fibonacci", "fibonacci uniform"), Method("Gauss", "gauss angles"), Method("adaptive", "cubature angles"),
         Method("piece by piece", term=Term("ies_flux"))),
        why="Between two measured angles the candela are a straight line, whose flux is known in closed form. A rule over "
            "the whole sphere does not know where the lines bend.",
        over="angles", integrand=(Term("ies_candela"),),
        cases=tuple({"luminaire": i} for i in range(4))),
    "lights/area_work": Study(
        "Cost of a digit: irradiance", Term("irradiance_light"),
        (lit("midpoints", 0), lit("random", 1), lit("stratified", 2), lit("Sobol", 3), lit("Sobol, angle", 4),
         lit("Gauss, angle", 5), Method("closed form", term=Term("irradiance_light"))),
        why="Even in solid angle the integrand is only a cosine, and Gauss points need few of a smooth one. The closed "
            "form still wins: one walk along the edge, whatever the digits.",
        cases=tuple({"light_shape": i} for i in range(4)), pixels="position"),
    "brdfs/phong": Study(
        "Cost of a digit: Phong's albedo", Term("albedo_phong"),
        (*BLIND, *GRIDS, *(Method(m.label.replace("D", "lobe"), m.rule) for m in DRAWN),
         Method("Gauss lobe", "gauss half"), Method("adaptive lobe", "cubature half")),
        why="Drawn from the lobe itself, nearly every sample counts the same: what is left is the cut at the horizon. "
            "Drawn blindly, nearly all of them miss a narrow lobe.",
        over="directions", integrand=(Term("brdf_phong", {"k_d": 0.0, "k_s": 1.0}),), sampler="blinn_phong",
        width=Term("m_from_exponent"), about="mirror", worst=EVERYWHERE,
        cases=({"exponent": 10.0}, {"exponent": 1000.0}, {"exponent": 1e5}, {"exponent": 1e7})),
    "brdfs/blinn_phong_brdf": Study(
        "Cost of a digit: Blinn-Phong's albedo", Term("albedo_blinn_phong"), (*BLIND, *GRIDS, *DRAWN, *HALVES),
        why="Gauss points in the halfway vector's own angles, stretched to the lobe, see the same smooth hill at every "
            "exponent. Over l the hill is a needle, and a rule that misses it does not know.",
        over="directions", integrand=(Term("brdf_blinn_phong", {"k_d": 0.0, "k_s": 1.0}),), sampler="blinn_phong",
        width=Term("m_from_exponent"), worst=EVERYWHERE,
        cases=({"exponent": 10.0}, {"exponent": 1000.0}, {"exponent": 1e5}, {"exponent": 1e7})),
    "microfacets/distribution": Study(
        "Cost of a digit: sum of D cos a", 1.0,
        (*BLIND, Method("rings", term=Term("facet_area", {"ndf": 2, "cosines": 1}), cost="rows",
                        ladder=(4, 8, 16, 32, 64, 128, 512, 2048)), Method("Gauss, angle", "gauss angles"), Method("Gauss, slope", "gauss half"),
         Method("adaptive, angle", "cubature angles"), Method("adaptive, slope", "cubature half")),
        why="In tan a / m every Beckmann lobe is the same hill, so one rule serves all. Over the angle a narrow lobe "
            "hides between the nodes, and an adaptive rule finds 0 and calls it converged.",
        over="halfways", integrand=(Term("d_beckmann"),), width="m", cases=WIDTHS),
    "microfacets/interreflections": Study(
        "Cost of a digit: EON's albedo", Term("albedo_eon"), SMOOTH,
        why="A matt lobe is broad: Gauss points see it whole. Its one crease, at s = 0, is all that holds them up.",
        over="directions", integrand=(Term("brdf_eon"),), cases=({"theta_v": 60.0},)),
    "microfacets/cook_torrance": Study(
        "Cost of a digit: Cook-Torrance's albedo", Term("albedo_cook_torrance"),
        (*BLIND, *GRIDS, *DRAWN, *HALVES, Method("Gauss-Laguerre", "laguerre importance"),
         Method("semi-analytic", "semi-analytic")),
        why="The semi-analytic way cuts the lobe where G bends and integrates around in closed form, so that the rest is "
            "smooth. Small m makes the drawn samples better and the blind ones useless.",
        over="directions", integrand=(Term("brdf_cook_torrance"),), sampler="beckmann", width="m", worst=EVERYWHERE,
        cases=WIDTHS),
    "geometry_term/smith": Study(
        "Cost of a digit: GGX's albedo", Term("albedo_ggx", {"alpha": "m", "f0": 1.0}),
        (*BLIND, *GRIDS, *DRAWN, Method("Gauss mirror", "gauss mirror"), *HALVES),
        why="Smith's G has no crease, and over l the horizon is the edge of the domain itself: twice the Gauss points a "
            "side, twice the digits. Over h the horizon cuts through, and that is a step.",
        over="directions", integrand=(Term("brdf_ggx", {"alpha": "m", "f0": 1.0}),), sampler="ggx", width="m",
        worst={"theta_v": (0.0, 46.0)}, cases=({"m": 1.0}, {"m": 0.5}, {"m": 0.1}, {"m": 0.01})),
}
