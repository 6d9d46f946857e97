"""One table by parameter name: symbol, unit, ranges, scale, default and meaning of every argument a twin can have.

It drives slider limits and labels, test grids, stability grids, axis titles and tool-tips. Angles are radians inside
and degrees on screen; `shown` and `entered` convert.
"""

import math
from dataclasses import dataclass
from typing import Literal

from app.lesson import Number
from app.problem import Usage, near


@dataclass(frozen=True)
class Quantity:
    symbol: str  # LaTeX
    unit: str
    low: float
    high: float
    default: Number
    words: str
    extreme: tuple[float, float] | None = None  # beyond the ordinary range; None: the same
    scale: Literal["linear", "log"] = "linear"
    kind: Literal["float", "int", "vec2", "vec3", "color"] = "float"

    @property
    def is_angle(self) -> bool:
        return self.unit == "rad"

    @property
    def screen_unit(self) -> str:
        return "°" if self.is_angle else self.unit.replace("^2", "²")

    @property
    def width(self) -> int:
        return {"vec2": 2, "vec3": 3, "color": 3}.get(self.kind, 1)

    def shown(self, value: Number) -> Number:
        """A value as the screen shows it: angles in degrees."""
        return scaled(value, 180 / PI) if self.is_angle else value

    def entered(self, value: Number) -> Number:
        """A value typed in screen units, as the formulas want it."""
        return scaled(value, PI / 180) if self.is_angle else value


TAU, PI = 2 * math.pi, math.pi

TABLE: dict[str, Quantity] = {
    # directions and cones
    "half_angle": Quantity(r"\theta", "rad", 0.0, PI, 0.6, "half the opening angle of a cone", extreme=(1e-12, PI)),
    "theta": Quantity(r"\theta", "rad", 0.0, PI / 2, 0.6, "polar angle from the normal", extreme=(0.0, PI)),
    "phi": Quantity(r"\varphi", "rad", -PI, PI, 0.4, "azimuth around the normal"),
    "d_theta": Quantity(r"\Delta\theta", "rad", 0.01, 1.0, 0.2, "height of a cell in polar angle", extreme=(1e-8, PI)),
    "d_phi": Quantity(r"\Delta\varphi", "rad", 0.01, 1.0, 0.2, "width of a cell in azimuth", extreme=(1e-8, TAU)),
    # the patch
    "distance": Quantity("r", "m", 0.5, 5.0, 2.0, "distance from the eye point", extreme=(1e-6, 1e8), scale="log"),
    "tilt": Quantity(r"\beta", "rad", -PI / 2, PI / 2, 0.0, "angle between the patch's normal and the line of sight"),
    "width": Quantity("w", "m", 0.05, 2.0, 0.8, "side of the square patch", extreme=(1e-6, 1e4), scale="log"),
    "samples": Quantity("N", "", 64, 16384, 2048, "number of counted points", (1, 60000), "log", "int"),
    "index": Quantity("i", "", 0, 63, 0, "number of a point, from 0", extreme=(0, 59999), kind="int"),
    "rows": Quantity("N", "", 2, 64, 8, "rows of cells from pole to pole", extreme=(1, 10000), scale="log", kind="int"),
    "towards": Quantity("d", "", -1.0, 1.0, (0.0, 0.0, 1.0), "unit vector of a ray from the eye", kind="vec3"),
    "s": Quantity("s", "", 0.0, 1.0, 0.5, "first coordinate in the unit square"),
    "t": Quantity("t", "", 0.0, 1.0, 0.5, "second coordinate in the unit square"),
    # disks, spheres, rectangles
    "radius": Quantity("r_0", "m", 0.05, 2.0, 0.5, "radius of a sphere or disk", extreme=(1e-6, 1e4), scale="log"),
    "height": Quantity("h", "m", 0.05, 5.0, 1.0, "height over a plane", extreme=(1e-6, 1e4), scale="log"),
    "offset": Quantity(r"\rho_0", "m", 0.0, 5.0, 0.5, "sideways distance from an axis", extreme=(0.0, 1e4)),
    "depth": Quantity("d_0", "m", 0.05, 2.0, 0.8, "the other side of a rectangle", extreme=(1e-6, 1e4), scale="log"),
    "x0": Quantity("x_0", "m", -2.0, 2.0, -0.5, "left edge of a rectangle", extreme=(-1e3, 1e3)),
    "x1": Quantity("x_1", "m", -2.0, 2.0, 0.5, "right edge of a rectangle", extreme=(-1e3, 1e3)),
    "y0": Quantity("y_0", "m", -2.0, 2.0, -0.5, "lower edge of a rectangle", extreme=(-1e3, 1e3)),
    "y1": Quantity("y_1", "m", -2.0, 2.0, 0.5, "upper edge of a rectangle", extreme=(-1e3, 1e3)),
    # triangles, polygons, meshes, seen from the origin or from the eye
    "a": Quantity("A", "m", -2.0, 2.0, (-0.5, -0.5, 1.0), "first corner of a triangle", kind="vec3"),
    "b": Quantity("B", "m", -2.0, 2.0, (0.5, -0.5, 1.0), "second corner of a triangle", kind="vec3"),
    "c": Quantity("C", "m", -2.0, 2.0, (0.0, 0.6, 1.0), "third corner of a triangle", kind="vec3"),
    "ab": Quantity("AB", "m", -2.0, 2.0, (1.0, 0.0, 0.0), "edge of a triangle, from A to B", kind="vec3"),
    "ac": Quantity("AC", "m", -2.0, 2.0, (0.5, 1.1, 0.0), "edge of a triangle, from A to C", kind="vec3"),
    "area": Quantity("N", "m^2", -4.0, 4.0, (0.0, 0.0, 1.1), "area vector of a triangle, AB x AC", kind="vec3"),
    "eye": Quantity("E", "m", -2.0, 2.0, (0.0, 0.0, 0.0), "the point from which it is seen", kind="vec3"),
    "corner_count": Quantity("n", "", 3, 5, 5, "corners of the polygon", kind="int"),
    "corner_a": Quantity("P_1", "", -1.0, 1.0, (-0.6, -0.5), "first corner of the outline", kind="vec2"),
    "corner_b": Quantity("P_2", "", -1.0, 1.0, (0.6, -0.5), "second corner of the outline", kind="vec2"),
    "corner_c": Quantity("P_3", "", -1.0, 1.0, (0.7, 0.3), "third corner of the outline", kind="vec2"),
    "corner_d": Quantity("P_4", "", -1.0, 1.0, (0.0, 0.8), "fourth corner of the outline", kind="vec2"),
    "corner_e": Quantity("P_5", "", -1.0, 1.0, (-0.7, 0.3), "fifth corner of the outline", kind="vec2"),
    "size": Quantity("S", "m", 1e-3, 2.0, 1.0, "scale of the outline", extreme=(1e-5, 1e3), scale="log"),
    "shape": Quantity("k", "", 0, 9, 0, "which of the scene's meshes", kind="int"),
    "x": Quantity("x", "m", -2.0, 2.0, 0.0, "the eye, sideways"),
    "y": Quantity("y", "m", -2.0, 2.0, 0.0, "the eye, up or down"),
    # measured luminaires (IES)
    "luminaire": Quantity("k", "", 0, 9, 0, "which of the luminaires", kind="int"),
    "setback": Quantity("a", "m", 0.2, 5.0, 1.0, "distance of the luminaire from the wall", extreme=(1e-3, 1e3)),
    "turn": Quantity(r"\alpha", "rad", -PI, PI, 0.0, "turn of the luminaire around the vertical"),
    "aim": Quantity(r"\delta", "rad", 0.0, PI / 2, 0.0, "angle of the luminaire's axis from straight down"),
    "meter_x": Quantity("x_E", "m", -3.0, 3.0, 0.0, "the lux meter, sideways"),
    "meter_s": Quantity("s_E", "m", -4.5, 3.0, 1.0, "the lux meter: up the wall, or below 0 out on the floor"),
    "plane": Quantity("C", "rad", 0.0, PI, 0.0, "azimuth of a photometric plane"),
    "way": Quantity("d", "m", -4.0, 4.0, (0.0, 0.0, -2.0), "from the luminaire to the lit point", kind="vec3"),
    "normal": Quantity("n", "", -1.0, 1.0, (0.0, 0.0, 1.0), "unit normal of the lit surface", kind="vec3"),
    "candela_below": Quantity("I_0", "cd", 0.0, 1000.0, 100.0, "intensity at the smaller angle of a ring"),
    "candela_above": Quantity("I_1", "cd", 0.0, 1000.0, 80.0, "intensity at the larger angle of a ring"),
    "row": Quantity("k", "", 1, 2, 1, "1: angles from the pole; 2: azimuths", kind="int"),
    "angle": Quantity(r"\gamma", "deg", -180.0, 180.0, 30.0, "an angle as a photometric file has it"),
    # radiometry and photometry
    "radiant_energy": Quantity("Q", "J", 1.0, 1000.0, 60.0, "energy carried by light", (1e-6, 1e9), "log"),
    "duration": Quantity("t_0", "s", 1e-3, 1.0, 0.01, "how long the light is on", extreme=(1e-6, 1e6), scale="log"),
    "time": Quantity("t", "s", 0.0, 1.0, 0.3, "time since the light went on", extreme=(0.0, 1e6)),
    "radiant_flux": Quantity(r"\Phi", "W", 0.1, 1000.0, 10.0, "energy per time: power of light", (1e-6, 1e9), "log"),
    "radiant_intensity": Quantity("I", "W/sr", 0.1, 1000.0, 10.0, "flux per solid angle", (1e-6, 1e9), "log"),
    "radiance": Quantity("L", "W/(m^2 sr)", 0.1, 1000.0, 100.0, "flux per area seen and sr", (1e-6, 1e9), "log"),
    "irradiance": Quantity("E", "W/m^2", 1.0, 1000.0, 500.0, "flux that arrives per area", (1e-6, 1e9), "log"),
    "rho": Quantity(r"\rho", "", 0.0, 0.95, 0.8, "share of the light that is reflected", extreme=(0.0, 0.999)),
    "patch_area": Quantity("A", "m^2", 1e-4, 1.0, 1e-2, "area of a sensor", extreme=(1e-9, 1e4), scale="log"),
    "opening": Quantity(r"\theta_0", "rad", 0.005, PI / 2, 0.3, "half the angle of a piece of sky", (1e-3, PI / 2)),
    "sky_piece": Quantity("k", "", 0, 2, 0, "which piece of sky: overhead, sun, window", kind="int"),
    "luminous_flux": Quantity(r"\Phi_v", "lm", 1.0, 1e5, 3000.0, "flux as the eye counts it", (1e-6, 1e9), "log"),
    "luminous_intensity": Quantity("I_v", "cd", 0.1, 1e5, 240.0, "luminous flux per solid angle", (1e-6, 1e9), "log"),
    "illuminance": Quantity("E_v", "lx", 0.1, 1e5, 500.0, "luminous flux that arrives per area", (1e-6, 1e9), "log"),
    "electrical_power": Quantity("P", "W", 1.0, 1000.0, 100.0, "power drawn from the mains", (1e-3, 1e6), "log"),
    "source_efficacy": Quantity(r"\eta_v", "lm/W", 1.0, 250.0, 30.0, "lumens per watt drawn", (1e-3, 683.0)),
    "radiation_efficacy": Quantity("K", "lm/W", 1.0, 683.0, 95.0, "lumens per watt of light", extreme=(1e-3, 683.0)),
    "radiated_share": Quantity(r"\eta_e", "", 0.05, 1.0, 0.9, "share of the power drawn that is radiated"),
    "wavelength": Quantity(r"\lambda", "nm", 380.0, 780.0, 555.0, "wavelength in air", extreme=(300.0, 2000.0)),
    "wavelength_low": Quantity(r"\lambda_1", "nm", 380.0, 500.0, 400.0, "shortest wavelength of a lamp"),
    "wavelength_high": Quantity(r"\lambda_2", "nm", 600.0, 780.0, 700.0, "longest wavelength of a lamp"),
    "temperature": Quantity("T", "K", 1000.0, 20000.0, 2700.0, "temperature of a black body", (800.0, 1e5), "log"),
    "lamp": Quantity("k", "", 0, 2, 0, "which lamp: black body, LED, equal energy", kind="int"),
    "linear": Quantity("x", "", 0.0, 1.0, 0.18, "a channel of linear light"),
    "encoded": Quantity("x'", "", 0.0, 1.0, 0.46, "a channel as sRGB stores it"),
    "from_wall": Quantity("x", "m", 0.05, 2.4, 0.7, "a point of the floor, from the wall", extreme=(0.01, 100.0)),
    "along_wall": Quantity("y", "m", -1.0, 1.0, 0.0, "a point of the floor, along the wall", extreme=(-100.0, 100.0)),
    "lamp_x": Quantity("x_L", "m", 0.4, 2.2, 1.7, "the lamp, from the wall", extreme=(0.1, 100.0)),
    "lamp_height": Quantity("z_L", "m", 1.1, 2.2, 1.7, "the lamp over the floor", extreme=(0.9, 100.0)),
    "sees": Quantity("k", "", 0, 2, 0, "what is counted: the lamp alone, shadows, the wall's light too", kind="int"),
    # lights
    "irradiance_facing": Quantity(r"E_\perp", "W/m²", 0.1, 1000.0, 10.0, "on a surface that faces the light",
                                  (0.0, 1e6), "log"),
    "position": Quantity("x", "m", -2.0, 2.0, (0.5, 0.3, 0.0), "the point that is shaded", kind="vec3"),
    "light_position": Quantity("p_L", "m", -2.0, 2.0, (0.4, -0.3, 1.0), "where the light is", kind="vec3"),
    "source_radius": Quantity("r_0", "m", 1e-3, 1.0, 0.05, "radius of the source", (1e-6, 100.0), "log"),
    "reach": Quantity("R", "m", 0.5, 20.0, 3.0, "distance from which on a light gives nothing", (1e-3, 1e4), "log"),
    "exponent": Quantity("n", "", 0.0, 100.0, 4.0, "exponent of a cosine", extreme=(0.0, 1e7)),
    "distribution": Quantity("f_e", "", 0, 2, 1, "which emission distribution", kind="int"),
    "off_axis": Quantity(r"\alpha", "rad", 0.0, PI / 2, 0.4, "angle from the beam's axis", extreme=(0.0, PI)),
    "cosine": Quantity(r"-l\cdot d", "", -1.0, 1.0, 0.9, "cosine of the angle from the beam's axis"),
    "hotspot": Quantity("H", "rad", 0.01, 1.4, 0.35, "half angle of the full cone", extreme=(1e-4, 1.5)),
    "falloff": Quantity("F", "rad", 0.01, 1.4, 0.6, "half angle of the cone beyond which is nothing", (1e-4, 1.5)),
    "threshold": Quantity(r"\theta_L", "rad", 0.01, 1.5, 1.0, "the angle printed as the last threshold"),
    "light_x": Quantity("x_L", "m", -2.0, 2.0, 0.0, "the light's middle, left or right"),
    "light_y": Quantity("y_L", "m", -2.0, 2.0, 0.0, "the light's middle, to the front or the back"),
    "light_height": Quantity("h", "m", 0.05, 3.0, 1.0, "the light's middle over the floor", (0.01, 100.0), "log"),
    "panel_width": Quantity("w", "m", 0.05, 3.0, 1.2, "one side of the panel", (1e-3, 100.0), "log"),
    "panel_depth": Quantity("d", "m", 0.05, 3.0, 0.8, "the other side of the panel", (1e-3, 100.0), "log"),
    "panel_tilt": Quantity(r"\beta", "rad", -PI / 2, PI / 2, 0.0, "0: the panel looks down; 90°: to the back"),
    "edge": Quantity("f_L", "", 0, 2, 0, "how the spotlight dims between its cones", kind="int"),
    "pattern": Quantity("p", "", 0, 1, 0, "whether every pixel has samples of its own", kind="int"),
    "map": Quantity("E", "", 0, 1, 0, "what the floor shows", kind="int"),
    "normal_length": Quantity(r"|\bar n|", "", 0.0, 1.0, 0.95, "length of the mean of many normals"),
    "kappa": Quantity(r"\kappa", "", 0.1, 1000.0, 10.0, "concentration of directions", (1e-6, 1e8), "log"),
    "strip": Quantity("a", "sr", -3.0, 3.0, 0.4, "solid angle of a part of a rectangle"),
    "sampling": Quantity("k", "", 0, 5, 0, "how the samples are placed", kind="int"),
    "to_sample": Quantity("r", "m", -2.0, 2.0, (0.3, 0.2, 1.0), "from the shaded point to a sample", kind="vec3"),
    "seen": Quantity("r'", "m", -2.0, 2.0, (0.3, 0.2, 1.0), "the panel's middle in its own axes", kind="vec3"),
    "level": Quantity(r"\log_4 N", "", 0, 5, 2, "4 to this power is the number of samples", kind="int"),
    "seed": Quantity("q", "", 0, 1000, 0, "which of the patterns of random samples", (0, 2147483647), kind="int"),
    # the Fresnel term
    "l_dot_h": Quantity(r"l \cdot h", "", 0.0, 1.0, 0.7, "cosine between the light and the facet's normal"),
    "eta": Quantity(r"\eta", "", 1.0, 3.0, 1.5, "index of the far side over the near side's", (0.35, 10.0), "log"),
    "k": Quantity("k", "", 0.0, 10.0, 3.0, "extinction: the imaginary part of a metal's index", extreme=(0.0, 30.0)),
    "f0": Quantity("F_0", "", 0.0, 0.95, 0.04, "share reflected at normal incidence", extreme=(0.0, 0.99)),
    "f_average": Quantity(r"F_{avg}", "", 0.0, 1.0, 0.5, "share of diffuse light reflected"),
    "f82": Quantity("F_{82}", "", 0.0, 1.0, 0.5, "share reflected at 82 degrees, l.h = 1/7"),
    "polariser": Quantity(r"\psi", "rad", 0.0, PI / 2, 0.0, "turn of the polariser before the eye"),
    "material": Quantity("i", "", 0, 9, 5, "which row of the tables of materials", kind="int"),
    "channel": Quantity("c", "", 0, 2, 0, "colour channel: red, green, blue", kind="int"),
    "wavelength_index": Quantity("j", "", 0, 11, 6, "which of twelve wavelengths", kind="int"),
    # shapes of area lights
    "light_shape": Quantity("k", "", 0, 3, 0, "which shape: panel, disk, sphere, polygon", kind="int"),
    "to_light": Quantity("r", "m", -2.0, 2.0, (0.3, 0.2, 1.0), "from the point to the light's middle", kind="vec3"),
    "reading": Quantity("k", "", 0, 2, 0, "how a program reads the spot: as meant, full angles, +l.d", kind="int"),
    "given": Quantity("k", "", 0, 2, 0, "which number is given: flux, exitance, radiance", kind="int"),
    "amount": Quantity("a", "", 0.1, 1000.0, 100.0, "the given one, in W, W/m² or W/(m² sr)", (1e-6, 1e9), "log"),
    # matter: n is +z, v = direction(theta_v, 0), l = direction(theta_l, phi); phi = 180 degrees is the mirror side
    "n": Quantity("n", "", -1.0, 1.0, (0.0, 0.0, 1.0), "unit normal of the surface", kind="vec3"),
    "l": Quantity("l", "", -1.0, 1.0, (-0.6, 0.0, 0.8), "unit vector to the light", kind="vec3"),
    "v": Quantity("v", "", -1.0, 1.0, (0.6, 0.0, 0.8), "unit vector to the eye", kind="vec3"),
    "h": Quantity("h", "", -1.0, 1.0, (0.0, 0.0, 1.0), "unit vector halfway between l and v", kind="vec3"),
    "theta_l": Quantity(r"\theta_l", "rad", 0.0, PI / 2, 0.7, "angle of the light from the normal"),
    "theta_v": Quantity(r"\theta_v", "rad", 0.0, PI / 2, 0.7, "angle of the eye from the normal"),
    "theta_h": Quantity(r"\theta_h", "rad", 0.0, PI / 2, 0.1, "angle of the halfway vector from the normal"),
    "theta_d": Quantity(r"\theta_d", "rad", 0.0, PI / 2, 0.5, "angle between the light and the halfway vector"),
    "n_dot_l": Quantity(r"n \cdot l", "", 0.0, 1.0, 0.7, "cosine of the light's angle from the normal"),
    "n_dot_v": Quantity(r"n \cdot v", "", 0.0, 1.0, 0.7, "cosine of the eye's angle from the normal"),
    "n_dot_h": Quantity(r"n \cdot h", "", 0.0, 1.0, 0.95, "cosine of the halfway vector's angle from the normal"),
    "r_dot_v": Quantity(r"r \cdot v", "", 0.0, 1.0, 0.95, "cosine between the mirror direction and the eye"),
    "m": Quantity("m", "", 0.01, 1.0, 0.3, "roughness: RMS slope of the facets", (1e-5, 10.0), "log"),
    "alpha": Quantity(r"\alpha", "", 0.01, 1.0, 0.3, "width of the GGX distribution", (1e-5, 10.0), "log"),
    "k_d": Quantity("k_d", "", 0.0, 1.0, 0.5, "share of the light that is reflected diffusely"),
    "k_s": Quantity("k_s", "", 0.0, 1.0, 0.5, "share of the light that is reflected specularly"),
    "sigma": Quantity(r"\sigma", "rad", 0.0, 1.0, 0.3, "spread of the facets' tilts, Oren-Nayar", (0.0, PI / 2)),
    "xi_1": Quantity(r"\xi_1", "", 0.0, 1.0, 0.5, "first random number of a sample", (1e-9, 0.99999)),
    "xi_2": Quantity(r"\xi_2", "", 0.0, 1.0, 0.5, "second random number of a sample"),
    "model": Quantity("k", "", 0, 9, 0, "which of the models", kind="int"),
    "lobe_scale": Quantity("k", "", 0, 2, 0, "what a lobe shows: f, f times n.l, or log f", kind="int"),
    # Phong and Blinn
    "summand": Quantity("c", "", 2.0, 8.0, 8.0, "what a short cut for the normalisation adds to the exponent"),
    "complaint": Quantity("k", "", 0, 4, 2, "which complaint about Blinn-Phong", kind="int"),
    # the reflectance equation
    "tile_rows": Quantity("N", "", 1, 24, 6, "rows of tiles from the pole to the horizon", (1, 32), "log", "int"),
    "to_sun": Quantity("s", "", -1.0, 1.0, (0.48, 0.6, 0.64), "unit vector to the sun", kind="vec3"),
    "sun_radiance": Quantity("L_s", "W/(m^2 sr)", 0.0, 60.0, 25.0, "radiance of the sun's middle"),
    "zenith_radiance": Quantity("L_0", "W/(m^2 sr)", 0.0, 10.0, 1.0, "radiance of the blue sky overhead"),
    "flaw": Quantity("k", "", 0, 5, 0, "what is wrong with the BRDF", kind="int"),
    "weight": Quantity("k", "", 0, 1, 1, "1: the integral has the cosine", kind="int"),
    "layer": Quantity("k", "", 0, 3, 3, "what the sky shows: L_i, f, the cosine, their product", kind="int"),
    # distributions of facets
    "slope2": Quantity(r"\tan^2 a", "", 0.0, 10.0, 0.1, "square of a facet's slope", extreme=(0.0, 1e18)),
    "ndf": Quantity("k", "", 0, 3, 2, "which distribution: Gauss, Blinn-Phong, Beckmann, GGX", kind="int"),
    "prefactor": Quantity("k", "", 0, 1, 0, "which prefactor: 1/4, or 1/pi as printed", kind="int"),
    "exposed": Quantity("k", "", 0, 1, 0, "exposure: each at its own peak, or all alike", kind="int"),
    "slope_ratio": Quantity("x", "", -3.0, 3.0, 0.8, "slope of a facet, in units of m"),
    "cosines": Quantity("k", "", 0, 1, 1, "1: area as seen from above; 0: the facets' own area", kind="int"),
    # grooves and rough diffuse surfaces
    "facet": Quantity(r"\alpha", "rad", -1.2, 1.2, 0.7, "lean of a facet's normal, positive to the right", (-1.5, 1.5)),
    "lean": Quantity(r"\theta", "rad", -1.5, 1.5, -0.8, "angle of a direction, positive to the right", (-1.57, 1.57)),
    "lean_l": Quantity(r"\theta_l", "rad", -1.5, 1.5, -0.6, "angle of the light, positive to the right", (-1.57, 1.57)),
    "lean_v": Quantity(r"\theta_v", "rad", -1.5, 1.5, 0.9, "angle of the eye, positive to the right", (-1.57, 1.57)),
    "roughness": Quantity("r", "", 0.0, 1.0, 0.5, "roughness as a file stores it, glTF's or EON's"),
    "disk_x": Quantity("x", "", -1.0, 1.0, 0.0, "place on the disk of a ball, from its middle to its rim at 1"),
    "phase": Quantity(r"\gamma", "rad", 0.0, 1.4, 0.0, "angle between the light and the eye", extreme=(0.0, 1.5)),
    "facets": Quantity("N", "", 100, 10000, 10000, "number of facets", (1, 20000), "log", "int"),
    "place": Quantity("i", "", 0, 9999, 0, "number of a place on the plate", kind="int"),
    "zoom": Quantity("Z", "", 1.0, 200.0, 1.0, "how much the plate is enlarged", scale="log"),
    "groove_width": Quantity("w", "µm", 5.0, 100.0, 20.0, "width of a groove", (0.1, 1000.0), "log"),
    # the geometry term
    "slope": Quantity(r"m\tan\theta", "", 0.05, 20.0, 1.0, "roughness times an angle's tangent", (0.0, 1e30), "log"),
    "steep": Quantity(r"\tan a", "", 0.05, 20.0, 1.0, "tangent of a facet's tilt", (0.0, 1e9), "log"),
    "tangent": Quantity(r"\tan\theta_v", "", 0.0, 20.0, 1.0, "tangent of the eye's angle", (0.0, 1e7)),
    "geometry": Quantity("G", "", 0, 3, 1, "which geometry term: none, V-groove, Smith, Smith correlated", kind="int"),
    "shows": Quantity("k", "", 0, 9, 0, "what the picture shows", kind="int"),
    "map_s": Quantity("s", "", 0.0, 1.0, 0.5, "place on the map, from the left"),
    "map_t": Quantity("t", "", 0.0, 1.0, 0.5, "place on the map, from the front"),
    "map_layers": Quantity("k", "", 0, 4, 4, "how many of the maps are on", kind="int"),
    "map_trap": Quantity("k", "", 0, 3, 0, "which map is read wrongly", kind="int"),
    "turned": Quantity(r"\psi", "rad", -PI, PI, 0.0, "turn of the picked point about the line of sight"),
    # bumps, from near and from afar
    "bump_slope": Quantity(r"\sigma", "", 0.01, 0.5, 0.2, "RMS slope of the bumps along one axis", (1e-3, 1.0)),
    "bumps": Quantity("K", "", 2.0, 2000.0, 8.0, "bumps side by side across the ball", (0.1, 1e4), "log"),
    "filtering": Quantity("k", "", 0, 3, 2, "a pixel's light: its middle, N places, m_eff, Toksvig", kind="int"),
    # plausible shading
    "coupling": Quantity("k", "", 0, 3, 3, "how body and mirror share the light: the last is in and out", kind="int"),
    "luminance": Quantity("L_v", "cd/m^2", 0.1, 1e4, 25.0, "light towards the eye, per area seen", (1e-6, 1e9), "log"),
    "ev100": Quantity("EV", "", -2.0, 16.0, 6.0, "exposure of a camera at ISO 100: 1 more lets in half the light",
                      extreme=(-20.0, 30.0)),
    "scene_linear": Quantity("x", "", 0.0, 16.0, 0.5, "linear number of a camera: 1 is just full", (0.0, 1e6)),
    "globe": Quantity("k", "", 0, 2, 0, "which of three lamps", kind="int"),
    "taken": Quantity("k", "", 0, 1, 0, "what a program takes for L_i: L, or I/r²", kind="int"),
    "gain": Quantity("g", "", 0.01, 100.0, 12.566, "how many times more light", (1e-6, 1e6), "log"),
    "mistake": Quantity("k", "", 0, 4, 0, "which one mistake a program makes", kind="int"),
    # a second renderer
    "base_colour": Quantity("c", "", 0.0, 1.0, 0.5, "one channel of glTF's base colour, linear"),
    "metallic": Quantity("k", "", 0.0, 1.0, 0.0, "1: a metal, its base colour is F0; 0: an insulator, F0 is 0.04"),
    "wipe": Quantity("x", "", -1.0, 1.0, 0.0, "where the second renderer's half begins"),
    "mapped": Quantity("k", "", 0, 2, 1, "how a file's roughness r is read: m = r, m = r², or all of glTF", kind="int"),
    "curve": Quantity("k", "", 0, 2, 0, "which tone curve: cut at 1, Reinhard, ACES fit", kind="int"),
}

# Vectors that are no values of a step: they follow from its angles
FROM_ANGLES = {"n": (), "l": ("theta_l", "phi"), "v": ("theta_v",), "h": ("theta_l", "phi", "theta_v")}


SPOKEN = {  # names that a person reads in other words
    "theta": "angle θ", "phi": "azimuth φ", "alpha": "width α", "rho": "albedo ρ", "eta": "index η",
    "theta_l": "light's angle θ", "theta_v": "eye's angle θ", "k_d": "diffuse k_d", "k_s": "specular k_s",
    "theta_h": "angle of h, θ", "theta_d": "angle of l from h, θ", "m": "roughness m", "lobe_scale": "lobes show",
    "f0": "F₀", "sigma": "spread σ", "n_dot_l": "n·l", "n_dot_v": "n·v", "n_dot_h": "n·h", "l_dot_h": "l·h",
    "r_dot_v": "r·v",
    # distributions of facets
    "ndf": "distribution", "slope_ratio": "slope / m", "exposed": "exposure",
}


def spoken(name: str) -> str:
    """The name a person reads: distance, half angle, angle θ."""
    return SPOKEN.get(name, name.replace("_", " "))


def quantity(name: str) -> Quantity:
    if name not in TABLE:
        raise Usage(f"there is no quantity {name}.{near(name, TABLE)}")
    return TABLE[name]


def shown(name: str, value: Number) -> Number:
    """A value of the table as the screen shows it."""
    return quantity(name).shown(value)


def entered(name: str, value: Number) -> Number:
    """A value of the table typed in screen units, as the formulas want it."""
    return quantity(name).entered(value)


def scaled(value: Number, factor: float) -> Number:
    return tuple(x * factor for x in value) if isinstance(value, tuple) else value * factor
