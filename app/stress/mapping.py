"""Which twin computes a stored value, and which of its arguments each input is."""

from dataclasses import dataclass, field

from app.lesson import Number


@dataclass(frozen=True)
class Twin:
    function: str
    inputs: dict[str, str] = field(default_factory=dict)  # name of an input -> argument; itself where it is not named
    fixed: dict[str, Number] = field(default_factory=dict)  # arguments the record does not carry
    degrees: tuple[str, ...] = ()  # inputs that the record has in degrees


MAPPING = {  # a name, or the beginning of names up to a dot
    "solid_angle.cone": Twin("solid_angle_cone", {"theta": "half_angle"}),
    "solid_angle.sphere_total": Twin("solid_angle_cone", fixed={"half_angle": 3.141592653589793}),
    "solid_angle.sphere": Twin("solid_angle_sphere", {"r": "radius", "d": "distance"}),
    "solid_angle.disk_onaxis": Twin("solid_angle_disk_on_axis", {"r": "radius", "h": "height"}),
    "solid_angle.disk_offaxis": Twin("solid_angle_disk", {"r": "radius", "h": "height", "rho": "offset"}),
    "solid_angle.triangle": Twin("solid_angle_triangle"),
    "solid_angle.rect_centered": Twin("solid_angle_rectangle", {"a": "width", "b": "depth", "d": "distance"}),
    "solid_angle.rect_offaxis": Twin("solid_angle_rectangle_off_axis", {"d": "distance"}),
    "projected_solid_angle.hemisphere": Twin("projected_solid_angle_cone", fixed={"half_angle": 1.5707963267948966}),
    "projected_solid_angle.sphere": Twin("projected_solid_angle_sphere", {"H": "distance"}, {"radius": 1.0}),
    "projected_solid_angle.disk_parallel": Twin(
        "projected_solid_angle_disk", {"r": "radius", "h": "height", "rho": "offset"}),
    "projected_solid_angle.rect_parallel": Twin("projected_solid_angle_rectangle", {"d": "distance"}),
    "projected_solid_angle.rect_perpendicular": Twin(
        "projected_solid_angle_wall", {"d": "distance", "b": "width", "h": "height"}),
    "projected_solid_angle.rect_clipped_by_horizon": Twin("projected_solid_angle_polygon", {"P": "corners"}),
    "projected_solid_angle.triangle": Twin("projected_solid_angle_polygon", {"P": "corners"}),
    # radiometry and photometry
    "irradiance.point": Twin("irradiance_point", {"I": "radiant_intensity", "d": "distance"}),
    "photometry.intensity_isotropic": Twin("luminous_intensity_isotropic", {"Phi": "luminous_flux"}),
    "photometry.illuminance_bulb_2p5m": Twin(
        "illuminance_isotropic", {"Phi": "luminous_flux", "d": "distance"}, {"theta": 0.0}),
    "photometry.lambert_exitance": Twin("radiant_exitance_lambert", {"L": "radiance"}),
    "photometry.candela_watts_per_sr_540THz": Twin("radiant_intensity_540thz", fixed={"luminous_intensity": 1.0}),
    "colour.linear_to_srgb": Twin("linear_to_srgb", {"x": "linear"}),
    "colour.srgb_to_linear": Twin("srgb_to_linear", {"x": "encoded"}),
    "light.spot_linear_cos": Twin("spot_linear_cos", {"cosang": "cosine", "H": "hotspot", "F": "falloff"}),
    "light.spot_flux": Twin("spot_flux", {"I0": "radiant_intensity", "H": "hotspot", "F": "falloff"}),
    "filter.toksvig_exponent": Twin("toksvig_exponent", {"Na_len": "normal_length", "n": "exponent"}),
    "filter.vmf_mean_length": Twin("vmf_mean_length"),
    "light.windowed_falloff_karis": Twin("windowed_falloff", {"d": "distance", "r": "reach"}),
    # the Fresnel term
    "fresnel.dielectric": Twin("f_dielectric", {"cos_i": "l_dot_h"}),
    "fresnel.conductor": Twin("f_conductor", {"n": "eta", "cos_i": "l_dot_h"}),
    "fresnel.schlick": Twin("f_schlick", {"F0": "f0", "cos": "l_dot_h"}),
    "fresnel.F82_hoffman_kutz": Twin("f_f82", {"F0": "f0", "F82": "f82", "cos": "l_dot_h"}),
    "fresnel.F0_from_ior": Twin("f0_from_eta"),
    "fresnel.average_dielectric_external": Twin("f_average_dielectric"),
    "fresnel.average_schlick": Twin("f_average_schlick", {"F0": "f0"}),
    # Phong and Blinn
    "vector.r_dot_v": Twin("mirror_cosine"),
    "vector.n_dot_h": Twin("halfway_cosine", fixed={"n": (0.0, 0.0, 1.0)}),
    "lobe.cos_power": Twin("cosine_lobe", {"n": "exponent"}),
    "norm.phong_brdf": Twin("normalisation_phong", {"n": "exponent"}),
    "norm.blinn_phong": Twin("normalisation_blinn_phong", {"n": "exponent"}),
    "albedo.blinn_phong_normalised": Twin("albedo_blinn_phong", {"n": "exponent"}),
    # facets and the Cook-Torrance BRDF
    "ndf.beckmann": Twin("d_at", {"alpha": "theta_h"}, {"ndf": 2}),
    "ndf.ggx": Twin("d_at", {"theta": "theta_h", "a": "m"}, {"ndf": 3}),
    "norm.blinn_ndf": Twin("d_blinn_phong_slope", {"n": "exponent"}, {"slope2": 0.0}),
    "norm.beckmann_projected_area": Twin("beckmann_within", fixed={"theta_h": 1.5707963267948966}),
    "beckmann.tail_beyond_deg": Twin("beckmann_tail", {"adeg": "theta_h"}, degrees=("adeg",)),
    "map.beckmann_m_to_phong_n": Twin("exponent_from_m"),
    "brdf.cook_torrance_vgroove_quarter": Twin("cook_torrance_at", {"F0": "f0"}),
    "brdf.cook_torrance_vgroove_deck": Twin("cook_torrance_printed_at", {"F0": "f0"}),
    "brdf.cook_torrance_smithHC_quarter": Twin("cook_torrance_smith_at", {"F0": "f0"}),
    "albedo.ggx_smithHC_F1": Twin("albedo_ggx", {"a": "alpha"}, {"f0": 1.0}),
    "albedo.cook_torrance_vgroove_quarter_F1": Twin("albedo_cook_torrance", fixed={"f0": 1.0}),
    "albedo.cook_torrance_vgroove_quarter_schlick": Twin("albedo_cook_torrance", {"F0": "f0"}),
    # the geometry term
    "geometry.vgroove": Twin("vgroove_at"),
    "smith.lambda_beckmann": Twin("lambda_beckmann_at", {"theta": "theta_v"}),
    "smith.G1_beckmann": Twin("g1_beckmann_at", {"theta": "theta_v"}),
    "smith.lambda_ggx": Twin("lambda_ggx_at", {"theta": "theta_v", "a": "alpha"}),
    # rough diffuse surfaces
    "brdf.oren_nayar_qualitative": Twin("brdf_oren_nayar_at"),
    "brdf.EON": Twin("brdf_eon_at", {"r": "roughness"}),
    "albedo.FON": Twin("albedo_fon", {"r": "roughness", "mu": "n_dot_v"}),
    "albedo.EON": Twin("albedo_eon", {"r": "roughness", "mu": "n_dot_v"}),
}


def mapped(name: str) -> Twin | None:
    """The twin of a record's name: the longest entry that is the name or its beginning."""
    fits = [key for key in MAPPING if name == key or name.startswith(key + ".")]
    return MAPPING[max(fits, key=len)] if fits else None
