"""Where the two models differ by definition: term by term, ours beside pyrender's, by its installed mesh.frag."""

from app.compare.material import Material, slope
from app.optics import twin
from app.optics.geometry_choice import geometry_term
from app.optics.gltf import DIELECTRIC, alpha_gltf
from app.optics.materials import INSULATORS
from app.optics.matter import matter_body

V_GROOVES, SMITH = "V-grooves: min(1, 2 n·h n·v / v·h, 2 n·h n·l / v·h)", "Smith, {}, of Beckmann's facets"
GEOMETRY = ("none", V_GROOVES, SMITH.format("light and eye apart"), SMITH.format("height-correlated"))
BODIES = {"brdf_oren_nayar": "Oren-Nayar", "brdf_eon": "EON"}
COUPLED = ("ρ/π, nothing taken off", "(1 - F(l·h)) ρ/π", "(1 - F(n·l)) ρ/π",
           "(1 - F(n·l)) (1 - F(n·v)) ρ / (π (1 - F_avg))")
LOBES = ("phong", "blinn")


def table(of: Material) -> list[tuple[str, str, str]]:
    """(term, ours, pyrender's)."""
    name, given, r, m = of.model.term.function, of.arguments, of.roughness, slope(of.arguments)
    lobe = any(word in name for word in LOBES)
    facets = m is not None and not lobe
    d = f"Beckmann, m = {m:.4g}" if facets else f"a cosine lobe as wide as m = {m:.4g}" if lobe else "none"
    metal = of.metallic == 1
    return [
        ("D", d, f"GGX, α = roughness² = {alpha_gltf(r):.4g} (roughness {r:.4g}, kept from 0.04 to 1)"),
        ("G", GEOMETRY[int(given.get("geometry", 1))] if facets else "none",
         "Schlick's fit to Smith, light and eye apart: x / (x (1 - k) + k), k = (roughness + 1)² / 8 = "
         f"{(r + 1)**2 / 8:.4g}; not height-correlated, and not GGX's own k = α / 2"),
        ("F", fresnel(name, given), f"Schlick's of v·h from F₀ = {mirrored(of)}, "
         + ("the base colour of a metal" if metal else "the same for all that is no metal")),
        ("below D G F", "4 n·l n·v" if facets else "none", "4 n·l n·v + 0.001, both cosines at least 0.001"),
        ("body", body(name, given), "none: metallic is 1" if metal else
         "(1 - F(v·h)) 0.96 colour / π: what the mirror takes is taken off once, not on the way in and on the way out"),
        ("light", "irradiance in W/m² or lx, radiance in W/(m² sr) or cd/m²",
         "intensity as it is: irradiance of a far lamp, I / d² of a near one; lux and candela by its documents, "
         "no exposure"),
        ("ambient", "none", "base colour times ambient_light; set to 0 here"),
        ("night side", "black", "n·l counts as 0.001: nothing is quite black"),
        ("output", "sRGB's curve", "the power 1/2.2, cut at 1, in 8 bits; colour maps are decoded by sRGB's curve"),
    ]


def mirrored(of: Material) -> str:
    shares = [DIELECTRIC * (1 - of.metallic) + colour * of.metallic for colour in of.colour]
    return " ".join(f"{x:.3g}" for x in (shares if len(set(shares)) > 1 else shares[:1]))


def fresnel(name: str, given: dict) -> str:
    if "material" in given:
        return "measured n and k, per channel"
    if "mapped" in given:
        return "Schlick's of l·h, from the same F₀"
    if "f0" in given:
        return f"Schlick's of l·h from F₀ = {given['f0']:.3g}"
    return f"none: the share k_s = {given['k_s']:.3g}" if "k_s" in given else "none"


def body(name: str, given: dict) -> str:
    if "mapped" in given:
        return COUPLED[3]
    if "coupling" in given:
        return f"{COUPLED[int(given['coupling'])]}, ρ = {given['rho']:.3g}"
    if "material" in given:
        share = matter_body(given["material"], 0)
        return "none" if given["material"] >= INSULATORS else f"{COUPLED[3]}, ρ = {share:.3g} in red"
    if name in BODIES:
        return f"{BODIES[name]}, ρ = {given['rho']:.3g}"
    share = given.get("rho", given.get("k_d", 0.0))
    return f"Lambert, ρ = {share:.3g}" if share else "none"


def at_45(of: Material) -> list[tuple[str, float, float]]:
    """D where a facet lies flat and G at 45 degrees to both sides, ours and pyrender's; of models that have them."""
    m, name = slope(of.arguments), of.model.term.function
    if m is None or any(word in name for word in LOBES):
        return []
    c = 0.5**0.5
    ours = geometry_term(1.0, c, c, c, m, of.arguments.get("geometry", 1))
    alpha = alpha_gltf(of.roughness)
    return [("D(0), 1/sr", float(twin("d_beckmann_slope")(0.0, m)), float(twin("d_ggx_slope")(0.0, alpha))),
            ("G at 45°", float(ours), float(twin("g_gltf")(c, c, of.roughness)))]
