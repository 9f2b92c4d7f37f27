"""What a dataset must contain: names, units and attributes, and the axes and points of its figure.

Axes, shown points and inputs follow from the configuration in the archive.
"""

import hashlib
import json
import math

import numpy as np

FILL_VALUE = 9.969209968386869e36  # a number at a point that no figure shows
NOT_SHOWN = -127  # a flag at such a point
AXIS_ROUNDING = 1e-12  # relative; steps of the load axis are powers
SUMMIT_ROUNDING = 1e-12  # relative; power laws of the roughness

# units and symbol
COORDINATES = {
    "load": ("1", "F_t*"),
    "viscosity": ("m2 s-1", "nu"),
    "particle_diameter": ("m", "x_a"),
    "roughness": ("m", "sigma"),
    "particle_density": ("m-2", "eta_a"),
    "normal_load": ("N", "F_t"),
}
DIMENSIONS = tuple(COORDINATES)[:-1]
# units, symbol and equation
NUMBERS = {
    "total_contact_area": ("1", "A_t*", "5"),
    "particle_contact_area_ratio": ("1", "A_sa,t*", "10"),
    "surface_contact_area_ratio": ("1", "A_ss,t*", "10"),
    "solid_load_fraction": ("1", "L_s", "9"),
    "fluid_load_fraction": ("1", "L_f", "9"),
    "separation": ("m", "d", "4"),
    "film_thickness": ("1", "H_c", "7"),
    "error_bound": ("1", "none", "none"),
}
# symbol, equation, and meanings of the flags by their values
FLAGS = {
    "lubrication_regime": (
        *("L_s", "section 3.1"),
        {0: "boundary", 1: "mixed", 2: "full_film", -1: "without_values", NOT_SHOWN: "not_shown"},
    ),
    "contact_mode": (
        *("A_sa,t*", "section 3.2"),
        {
            **{0: "two_body", 1: "surface_surface", 2: "hybrid", 3: "particle_surface"},
            **{-1: "without_values", NOT_SHOWN: "not_shown"},
        },
    ),
    "solution_status": (
        *("none", "1-8"),
        {
            **{0: "converged", 1: "outside_film_formula", 2: "coverage_exceeded"},
            **{3: "not_converged", 4: "area_exceeded", 5: "load_exceeded"},
            NOT_SHOWN: "not_shown",
        },
    ),
}
GLOBAL_FIXED = {
    "Conventions": "CF-1.11, ACDD-1.3",
    "source": "doi:10.3389/fmech.2024.1390335",
    "license": "CC-BY-4.0",
}
# this program derives the values of these attributes from the configuration
GLOBAL_DERIVED = {"title", "rtol", "model_parameters", "configuration_sha256", "id"}
# attributes with texts: only the sums of the files protect them
GLOBAL_TEXTS = {
    *("summary", "keywords", "references", "comment", "history", "acknowledgement", "project"),
    *("creator_name", "creator_type", "institution", "contributor_name", "contributor_role"),
    *("naming_authority", "standard_name_vocabulary", "schema_version", "processing_level"),
}
TEXTS = {"long_name", "comment"}  # such attributes of a variable
TIGHTEST, LOOSEST = 1e-11, 1e-2  # rtol that the workflow allows
MOST_POINTS = 5_000_000  # of one dataset, which is read at once
# attribute `model_parameters`: the name of each input in configuration/parameters.json
INPUTS = {
    "E_ss": "elastic_modulus_surfaces",
    "E_sa": "elastic_modulus_particle",
    "H_s1": "hardness_surface_1",
    "H_s2": "hardness_surface_2",
    "k": "yield_pressure_ratio",
    "omega_ratio": "plastic_interference_ratio",
    "R_x": "ball_radius",
    "G": "material_parameter",
    "V": "hardness_parameter",
    "kappa": "ellipticity",
    "U_per_viscosity": "speed_per_viscosity",
    "A_n": "apparent_area",
    "mean_ratio": "mean_ratio",
    "sigma_a_ratio": "spread_ratio",
    "truncation": "truncation",
    "participation": "participation",
    "h_e_ratio": "elastic_depth_ratio",
    "particle_plane": "particle_plane",
    "film_load": "film_load",
}
# keys of a scene and their units in SI
SCENE_UNITS = {
    "viscosity": ("viscosity_cSt", 1e-6),
    "particle_diameter": ("particle_diameter_nm", 1e-9),
    "roughness": ("roughness_nm", 1e-9),
    "particle_density": ("particle_density_per_m2", 1.0),
}
RELATIVE_DIAMETER = "particle_diameter_per_roughness"


# --- names, types and attributes ---


def form_findings(file):
    """Faults in the structure and the attributes of an open dataset."""
    known = [*COORDINATES, *NUMBERS, *FLAGS]
    extra = set(file.variables) - {*known}
    yield from (f"has the unknown variable {name}" for name in sorted(extra))
    yield from (f"has no variable {name}" for name in known if name not in file.variables)
    if file.groups or file.vltypes or file.cmptypes or file.enumtypes:
        yield "has groups or types of its own"
    if tuple(file.dimensions) != DIMENSIONS:
        yield f"has the dimensions {', '.join(file.dimensions)}"
    points = math.prod(len(dimension) for dimension in file.dimensions.values())
    if points > MOST_POINTS:
        yield f"has {points} points, more than the {MOST_POINTS} that are read"
    yield from attribute_findings("", attributes(file), GLOBAL_FIXED, GLOBAL_DERIVED | GLOBAL_TEXTS)
    for name in known:
        if name in file.variables:
            yield from variable_findings(name, file[name])


def variable_findings(name, variable):
    """Faults in the storage, dimensions, type and attributes of a variable."""
    expected_type = "<i1" if name in FLAGS else "<f8"
    expected_dimensions = DIMENSIONS
    if name in COORDINATES:
        expected_dimensions = ("load",) if name == "normal_load" else (name,)
    if variable.chunking() == "contiguous":  # netCDF4 says so of a virtual dataset too
        yield f"{name} has no chunks, so its numbers may lie in another file"
    if variable.dimensions != expected_dimensions:
        yield f"{name} has the dimensions {', '.join(variable.dimensions)}"
    if np.dtype(variable.dtype) != np.dtype(expected_type):
        yield f"{name} has the type {variable.dtype}"
    yield from attribute_findings(name, attributes(variable), expected_attributes(name), TEXTS)


def expected_attributes(name):
    """Attributes of the variable ``name`` whose values are known."""
    if name in COORDINATES:
        units, symbol = COORDINATES[name]
        return {"units": units, "symbol": symbol}
    known = {"units": "1", "coordinates": "normal_load"}
    if name in FLAGS:
        symbol, equation, meanings = FLAGS[name]
        return known | {
            "symbol": symbol,
            "equation": equation,
            "flag_values": list(meanings),
            "flag_meanings": " ".join(meanings.values()),
            "coverage_content_type": "qualityInformation",
        }
    known |= {"ancillary_variables": "solution_status", "coverage_content_type": "modelResult"}
    units, symbol, equation = NUMBERS[name]
    return known | {
        "units": units,
        "symbol": symbol,
        "equation": equation,
        "_FillValue": FILL_VALUE,
    }


def attributes(owner):
    """Attributes of a dataset or variable as plain values."""
    values = {name: owner.getncattr(name) for name in owner.ncattrs()}
    return {name: getattr(value, "tolist", lambda v=value: v)() for name, value in values.items()}


def attribute_findings(owner, present, fixed, others):
    """Unknown attributes, and ``fixed`` ones of another value.

    A program may change numbers by an unknown attribute.  An attribute is known if it is ``fixed``
    or named in ``others``.
    """
    prefix = f"{owner}: " if owner else ""
    for name in sorted(present.keys() - fixed.keys() - others):
        yield f"{prefix}unknown attribute {name}"
    for name, value in fixed.items():
        if present.get(name) != value:
            yield f"{prefix}attribute {name} is {present.get(name)!r}, not {value!r}"


# --- axes, shown points and inputs, by the configuration ---


def in_si(value, unit):
    """``value`` times ``unit``, to the twelve digits that count."""
    return float(f"{value * unit:.12g}")


def curve_groups(scene):
    """For each group of curves of a scene: the values [SI] of its four conditions."""
    for group in scene["curves"]:
        keys = {name: (group.get(key), unit) for name, (key, unit) in SCENE_UNITS.items()}
        absolute = {n: {in_si(v, unit) for v in vs} for n, (vs, unit) in keys.items() if vs}
        if RELATIVE_DIAMETER not in group:
            yield absolute
            continue
        for sigma in group["roughness_nm"]:
            diameters = {in_si(ratio * sigma, 1e-9) for ratio in group[RELATIVE_DIAMETER]}
            yield absolute | {"roughness": {in_si(sigma, 1e-9)}, "particle_diameter": diameters}


def expected_axes(scene, config, newtons_per_load):
    """Values [SI] of the five axes of a scene, increasing."""
    axis = scene.get("load_axis", config.get("load_axis"))
    if axis["count"] > MOST_POINTS:
        raise ValueError(f"the configuration has {axis['count']} loads")
    first, last = (in_si(newtons / newtons_per_load, 1.0) for newtons in axis["load_N"])
    named = [value for value in scene.get("named_loads", []) if first <= value <= last]
    axes = {"load": np.unique([*np.geomspace(first, last, axis["count"]), *named])}
    groups = list(curve_groups(scene))
    for name in SCENE_UNITS:
        axes[name] = np.array(sorted(set().union(*(group[name] for group in groups))))
    return axes


def expected_points(scene, axes):
    """Which combinations of ``axes`` a scene shows, as an array over them."""
    shown = np.zeros([values.size for values in axes.values()], dtype=bool)
    for group in curve_groups(scene):
        chosen = [np.isin(axes[name], list(group[name])) for name in SCENE_UNITS]
        shown[np.ix_(np.ones(axes["load"].size, dtype=bool), *chosen)] = True
    return shown


def configuration_findings(data, name, config, inputs):
    """Differences between a dataset and the configuration.

    ``data`` is a `recompute.Dataset`, ``name`` that of its figure, ``config`` and ``inputs`` are
    the files config.json and parameters.json.
    """
    scene = config["scenes"][name]
    if data.title != scene["title"]:
        yield "title is not that of the configuration"
    rtol = scene.get("rtol", config.get("rtol"))
    if data.rtol != rtol:
        yield f"rtol is {data.rtol:g}, in the configuration {rtol:g}"
    if not TIGHTEST <= rtol <= LOOSEST:
        yield f"rtol is {rtol:g}, which the workflow does not allow"
    axes = expected_axes(
        scene, config, inputs["apparent_area"] * inputs["elastic_modulus_surfaces"]
    )
    for axis, expected in axes.items():
        found = data.axes[axis]
        if found.shape != expected.shape or not close(found, expected, AXIS_ROUNDING):
            yield f"{axis} is not that of the configuration"
            return
    if (data.shown != expected_points(scene, axes)).any():
        yield "shows other points than the configuration"
    yield from input_findings(data, inputs)
    if data.identity != identity(data, scene, inputs):
        yield "configuration_sha256 or id is not that of the configuration"


def identity(data, scene, inputs):
    """The SHA-256 of the configuration and the id that follows from it."""
    groups = [
        {name: sorted(values) for name, values in group.items()} for group in curve_groups(scene)
    ]
    request = {"load": data.axes["load"].tolist(), "groups": groups}
    asked = {"parameters": inputs, "rtol": data.rtol, "request": request}
    digest = hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()
    return digest, f"thirdbody-{digest[:16]}"


def input_findings(data, inputs):
    """Inputs in ``model_parameters`` that are not those of the configuration."""
    known = {*INPUTS, "phi_a", "eta_s", "R", "sigma_s", "y_s"}
    yield from (f"unexpected input {key}" for key in sorted(data.model.keys() - known))
    for key, name in INPUTS.items():
        if data.model[key] != inputs[name]:
            yield f"{key} is {data.model[key]}, in the configuration {inputs[name]}"
    sizes = "uncentred" if inputs["mean_ratio"] == 0.0 else "centred"
    if data.model["phi_a"] != sizes:
        yield f"phi_a is {data.model['phi_a']}, with a mean_ratio of {inputs['mean_ratio']}"
    sigma = data.axes["roughness"]
    ratio = sigma / inputs["reference_roughness"]
    radius = inputs["summit_radius"] * ratio ** inputs["summit_radius_exponent"]
    parameter = inputs["summit_parameter"] * ratio ** inputs["summit_parameter_exponent"]
    offset = inputs["summit_offset_ratio"] / ratio ** inputs["summit_parameter_exponent"]
    for key, expected in (
        ("R", radius),
        ("eta_s", parameter / (radius * sigma)),
        ("sigma_s", inputs["summit_deviation_ratio"] * sigma),
        ("y_s", offset * sigma),
    ):
        if not close(np.array(data.model[key]), expected, SUMMIT_ROUNDING):
            yield f"{key} is not that of the configuration"


def close(found, expected, tolerance):
    return found.shape == expected.shape and np.allclose(found, expected, rtol=tolerance, atol=0.0)
