"""Solved points as an archival dataset: one table of variables gives names, units and meaning."""

from __future__ import annotations

import errno
import hashlib
import json
from collections.abc import Collection
from importlib.metadata import PackageNotFoundError, version

import netCDF4  # noqa: F401  xarray would import it at the first file
import numpy as np
import xarray as xr

from thirdbody.data.scene import DIMENSIONS, Scene
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import CONTACT_MODES, LUBRICATION_REGIMES, SOLUTION_STATUSES
from thirdbody.solver.solve import DEFAULT_RTOL, check_variables, checked_axis, solve

SCHEMA_VERSION = "1.0"
PAPER_DOI = "10.3389/fmech.2024.1390335"
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)

COORDINATES = {
    "load": ("1", "dimensionless mean normal load", "F_t*"),
    "viscosity": ("m2 s-1", "kinematic viscosity of the lubricant, 0 when dry", "nu"),
    "particle_diameter": ("m", "mean diameter of the third particles, 0 without them", "x_a"),
    "roughness": ("m", "equivalent root mean square surface roughness", "sigma"),
    "particle_density": ("m-2", "number of particles per unit area", "eta_a"),
    "normal_load": ("N", "normal load", "F_t"),
}
# What ACDD-1.3 asks of every file beside the attributes that depend on its content; the dates are
# that of this version of the software, so that the same inputs give the same bytes.
RELEASE_DATE = "2026-11-21"
DISCOVERY = {
    "naming_authority": "thirdbody",
    "history": "computed by thirdbody from the equations of the paper",
    "comment": (
        "nan: the point has no solution, and solution_status says why; a value beside the status "
        "not_converged is one that float64 does not resolve to rtol"
    ),
    "acknowledgement": "Chen & Horng (2024) for the model",
    "project": "thirdbody",
    "program": "reproduction of published models",
    "processing_level": "model result",
    "institution": "The thirdbody developers",
    "creator_type": "group",
    "creator_institution": "The thirdbody developers",
    "creator_url": f"https://doi.org/{PAPER_DOI}",
    "creator_email": "not given",
    "contributor_name": "Chen Y-Y, Horng J-H",
    "contributor_role": "authors of the model",
    "publisher_name": "The thirdbody developers",
    "publisher_type": "group",
    "publisher_institution": "The thirdbody developers",
    "publisher_url": f"https://doi.org/{PAPER_DOI}",
    "publisher_email": "not given",
    "metadata_link": f"https://doi.org/{PAPER_DOI}",
    "platform": "model",
    "platform_vocabulary": "none",
    "instrument": "none",
    "instrument_vocabulary": "none",
    "keywords_vocabulary": "none",
    "date_created": RELEASE_DATE,
    "date_issued": RELEASE_DATE,
    "date_modified": RELEASE_DATE,
    "date_metadata_modified": RELEASE_DATE,
}
# name: units, long name, symbol, equation of the paper
QUANTITIES = {
    "total_contact_area": ("1", "total real contact area over apparent area", "A_t*", "5"),
    "particle_contact_area_ratio": (
        "1",
        "contact area of particles over total real contact area",
        "A_sa,t*",
        "10",
    ),
    "surface_contact_area_ratio": (
        "1",
        "contact area of summits over total real contact area",
        "A_ss,t*",
        "10",
    ),
    "solid_load_fraction": ("1", "share of the load borne by the solids", "L_s", "9"),
    "fluid_load_fraction": ("1", "share of the load borne by the fluid", "L_f", "9"),
    "separation": ("m", "mean separation of the two surfaces", "d", "4"),
    "film_thickness": ("1", "central film thickness over ball radius", "H_c", "7"),
}
ERROR_BOUND = {
    "error_bound": ("1", "bound on the relative error of every variable", "none", "none"),
}
FLAGS = {
    "lubrication_regime": ("lubrication regime", "L_s", "section 3.1", LUBRICATION_REGIMES),
    "contact_mode": ("contact mode", "A_sa,t*", "section 3.2", CONTACT_MODES),
    "solution_status": ("status of the solution", "", "1-8", SOLUTION_STATUSES),
}
CONTRACT = (*QUANTITIES, *FLAGS)  # variables of every dataset of a figure
DESCRIBED = (*CONTRACT, *ERROR_BOUND)


def software_version() -> str:
    """Version of this package, as installed."""
    try:
        return version("thirdbody")
    except PackageNotFoundError:
        return "not installed"


def grid(
    load,
    viscosity,
    particle_diameter,
    roughness,
    particle_density,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = CONTRACT,
) -> xr.Dataset:
    """Every combination of five 1-D axes, as a dataset with these five dimensions.

    ``load`` F_t* [1], ``viscosity`` [m2/s], ``particle_diameter`` [m], ``roughness`` [m],
    ``particle_density`` [m-2]; ``rtol`` is the relative error asked for in every variable.
    ``variables`` names those that are wanted beside ``solution_status``, out of those of
    ``Solution``.  Raises ``ValueError`` for an axis that is not 1-D, increasing and of physical
    meaning, and for an unknown variable.
    """
    axes = grid_axes(load, viscosity, particle_diameter, roughness, particle_density)
    names = with_status(variables)
    solution = solve(*np.ix_(*axes.values()), parameters, rtol, names)
    values = {name: getattr(solution, name) for name in names}
    return described_grid(axes, values, parameters, rtol)


def with_status(variables) -> list[str]:
    """``variables`` and the status that tells what their nan mean; ``ValueError`` as in ``grid``."""
    check_variables(variables)
    return [name for name in DESCRIBED if name in variables or name == "solution_status"]


def grid_axes(*given) -> dict:
    """The five axes of a grid by name; ``ValueError`` as in ``grid``."""
    return {name: _checked_increasing(name, v) for name, v in zip(DIMENSIONS, given, strict=True)}


def described_grid(axes, values, parameters: Parameters, rtol: float) -> xr.Dataset:
    """The dataset of ``grid`` around ``values``, an array over all ``axes`` for each variable."""
    request = {name: axis.tolist() for name, axis in axes.items()}
    return _dataset(axes, values, parameters, rtol, "Three-body contact on a grid", request)


def scene_dataset(scene: Scene, parameters: Parameters, rtol: float = DEFAULT_RTOL) -> xr.Dataset:
    """The dataset of one figure; combinations that it does not show hold ``_FillValue``."""
    axes = {name: scene.axis(name) for name in DIMENSIONS}
    shape = tuple(axis.size for axis in axes.values())
    values = {name: np.full(shape, FILL_FLOAT) for name in QUANTITIES}
    values |= {name: np.full(shape, FILL_FLAG) for name in FLAGS}
    for group in scene.groups:
        place = scene.placed(group)
        group_axes = [scene.load, *(getattr(group, name) for name in DIMENSIONS[1:])]
        solution = solve(*np.ix_(*group_axes), parameters=parameters, rtol=rtol)
        for name in values:
            values[name][place] = getattr(solution, name)
    request = {
        "load": scene.load.tolist(),
        "groups": [
            {name: getattr(group, name).tolist() for name in DIMENSIONS[1:]}
            for group in scene.groups
        ],
    }
    return _dataset(axes, values, parameters, rtol, scene.title, request)


def write_dataset(dataset: xr.Dataset, path) -> None:
    """Write ``dataset`` as NetCDF-4: the same dataset gives the same bytes.

    Its values are written as they are, those that hold ``FILL_FLOAT`` or ``FILL_FLAG`` being the
    missing ones: the nan of an unsolved point stays what it is.  Raises ``OSError`` if there is no
    room, however the library below says so.
    """
    # smallest of what every NetCDF-4 library reads, by benchmarks/measure_compression.py,
    # to 0.2 %: level 9 takes half as long again to write
    compressed = {"zlib": True, "complevel": 6, "shuffle": False}
    encoding = {name: {"_FillValue": None} for name in dataset.coords}
    encoding |= {
        name: compressed | {"chunksizes": dataset[name].shape} for name in dataset.data_vars
    }
    try:
        dataset.to_netcdf(path, engine="netcdf4", format="NETCDF4", encoding=encoding)
    except RuntimeError as error:
        raise OSError(errno.EIO, str(error), str(path)) from None


def read_dataset(path) -> xr.Dataset:
    """A dataset of ``write_dataset``, in memory; ``OSError`` names the file if it is damaged."""
    try:
        with xr.open_dataset(path, engine="netcdf4") as dataset:
            loaded = dataset.load()
        missing = [name for name in (*DIMENSIONS, *QUANTITIES) if name not in loaded.variables]
        if not missing or all(f"{name}_low" in loaded for name in QUANTITIES):
            return loaded
        reason = f"no {missing[0]}"
    except Exception as error:
        reason = type(error).__name__
    raise OSError(f"{path} cannot be read ({reason}); remake it: snakemake -c2 --force {path}")


def _checked_increasing(name, values):
    axis = np.atleast_1d(checked_axis(name, values))
    if axis.ndim != 1 or axis.size == 0 or (np.diff(axis) <= 0.0).any():
        raise ValueError(f"{name} has shape {axis.shape}; allowed: one increasing dimension")
    return axis


def _dataset(axes, values, parameters, rtol, title, request) -> xr.Dataset:
    """Coordinates, variables and attributes of the data contract around solved ``values``."""
    variables = {
        name: (DIMENSIONS, values[name], _quantity_attributes(*row))
        for name, row in (QUANTITIES | ERROR_BOUND).items()
        if name in values
    }
    variables |= {
        name: (DIMENSIONS, values[name], _flag_attributes(*row))
        for name, row in FLAGS.items()
        if name in values
    }
    coordinates = {name: (name, axis, _coordinate_attributes(name)) for name, axis in axes.items()}
    newtons = axes["load"] * parameters.newtons_per_load
    coordinates["normal_load"] = ("load", newtons, _coordinate_attributes("normal_load"))
    attributes = _global_attributes(title, parameters, axes["roughness"], rtol, request)
    return xr.Dataset(variables, coordinates, attributes)


def _coordinate_attributes(name):
    units, long_name, symbol = COORDINATES[name]
    return {"units": units, "long_name": long_name, "symbol": symbol}


def _quantity_attributes(units, long_name, symbol, equation):
    return {
        "units": units,
        "long_name": long_name,
        "symbol": symbol,
        "equation": equation,
        "ancillary_variables": "solution_status",
        "coverage_content_type": "modelResult",
        "_FillValue": FILL_FLOAT,
    }


def _flag_attributes(long_name, symbol, equation, meanings):
    return {
        "units": "1",
        "long_name": long_name,
        "symbol": symbol or "none",
        "equation": equation,
        "flag_values": np.arange(len(meanings), dtype=np.int8),
        "flag_meanings": " ".join(meanings),
        "coverage_content_type": "qualityInformation",
        "_FillValue": FILL_FLAG,
    }


def _global_attributes(title, parameters, roughness, rtol, request) -> dict:
    configuration = {"parameters": parameters.as_dict(), "rtol": rtol, "request": request}
    canonical = json.dumps(configuration, sort_keys=True)
    conventions = "CF-1.11, ACDD-1.3"
    return {
        "Conventions": conventions,
        "conventions": conventions,
        "title": title,
        "summary": (
            "Load and real contact area shared by summits, third particles and a lubricant film "
            "between two rough surfaces, computed from the equations printed by Chen & Horng "
            "(2024) with the parameters in model_parameters."
        ),
        "keywords": "tribology, three-body contact, mixed lubrication, real contact area",
        "source": f"doi:{PAPER_DOI}",
        "references": f"Chen & Horng (2024), Front. Mech. Eng. 10:1390335, doi:{PAPER_DOI}",
        "license": "CC-BY-4.0",
        "creator_name": "The thirdbody developers",
        "standard_name_vocabulary": "CF Standard Name Table v93",
        "schema_version": SCHEMA_VERSION,
        "software_version": software_version(),
        "configuration_sha256": hashlib.sha256(canonical.encode()).hexdigest(),
        "rtol": rtol,
        **DISCOVERY,
        "id": f"thirdbody-{hashlib.sha256(canonical.encode()).hexdigest()[:16]}",
        "product_version": software_version(),
        "model_parameters": parameters.as_attribute(roughness),
    }
