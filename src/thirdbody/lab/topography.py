"""``surface``: roughness, and density and radius of the summits, of measured topographies."""

import warnings
from os import PathLike
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from thirdbody.conditions import OutOfRangeWarning, checked_number, warn_outside
from thirdbody.core.parameters import Parameters, mccool_summits
from thirdbody.extras import require
from thirdbody.inputs import or_calibrated
from thirdbody.variables import AXES

FORMS = {
    "none": "center",
    "tilt": "height",
    "curvature": "curvature",
}  # detrend of SurfaceTopography
STEEPEST = 1.0  # root mean square slope
MOST_FORM = 0.5  # of the variance of the heights, above which a parabola is probably no roughness


def surface(
    *surfaces: str | PathLike | NDArray | Any,
    scale_nm: float | None = None,
    form: str = "tilt",
    spacing_nm: float | None = None,
    **options: Any,
) -> pd.DataFrame:
    """Roughness and summits of measured topographies, and of the equivalent surface of their contact.

    SurfaceTopography reads the files and computes slopes and curvatures as finite differences over one
    distance in both directions.  From the moments m_0 (heights), m_2 (slopes) and m_4 (curvatures) of
    profiles, McCool (1987, J. Tribol. 109:264) has eta_s = m_4/(6 sqrt(3) pi m_2) and
    R = 3 sqrt(pi)/(8 sqrt(m_4)), for isotropic surfaces with Gaussian heights.  Moments of two surfaces add.

    Parameters
    ----------
    *surfaces : path, array or topography
        Files of an instrument, or x, y and z in columns: all formats that SurfaceTopography reads; arrays of
        heights, shape (nx, ny); or topographies of SurfaceTopography.
    scale_nm : float or quantity, optional
        The distance for slopes and curvatures [nm], by default the largest point spacing.  The lateral
        resolution of instruments is often coarser than the spacing: use the resolution.  eta_s and R depend
        on it: at ten times the distance, a typical surface has far fewer and blunter summits.
    form : {"tilt", "curvature", "none"}
        What is subtracted from the heights as the form of the body: a plane, a parabola, as for a ball, or
        the mean.
    spacing_nm : float or quantity, optional
        Of arrays, the point spacing [nm]; their heights are then in nm.  Instead of it ``physical_sizes``
        and ``unit`` are for lengths and heights in another unit.
    **options
        Information that is missing in files or arrays, as arguments of SurfaceTopography: ``unit="um"``,
        ``physical_sizes``, and of files ``height_scale_factor``.

    Returns
    -------
    pandas.DataFrame
        A row for each surface, by file or number, and a row ``equivalent``: ``roughness``, the root mean
        square height [m], sigma of the equivalent surface; ``summit_density`` eta_s [m-2] and
        ``summit_radius`` R [m]; ``slope`` [1] and ``curvature`` [m-1], root mean squares of profiles over
        the distance ``scale`` [m].

    Raises
    ------
    ValueError
        For other than one or two surfaces, a topography without a unit, points that are not evenly spaced,
        a scale below the point spacing, a surface without slopes or curvatures over the scale, and an
        unknown form.
    ModuleNotFoundError
        If SurfaceTopography is not installed: the extra ``surface`` installs it.

    Warns
    -----
    OutOfRangeWarning
        If a parabola explains more than half of the variance of the heights, and for slopes and a roughness
        that no machined surface has.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> rough = 100.0 * np.random.default_rng(1).standard_normal((64, 64))  # [nm]
    >>> table = tb.lab.surface(rough, rough, spacing_nm=1000)
    >>> (1e9 * table["roughness"]).round(1).to_dict()  # [nm]
    {'surface 1': 100.3, 'surface 2': 100.3, 'equivalent': 141.8}
    >>> inputs = tb.lab.surface_parameters(table)
    """
    require("surface", "SurfaceTopography")
    if len(surfaces) not in (1, 2):
        raise ValueError(f"surfaces are {len(surfaces)}; allowed: one, or two in contact")
    topographies = {}
    for number, each in enumerate(surfaces, 1):
        is_file = isinstance(each, str | PathLike)
        name = str(each) if is_file else f"surface {number}"
        if name in topographies:
            name = f"{name} ({number})"
        topographies[name] = _without_form(name, _topography(name, each, spacing_nm, options), form)
    spacing = max(max(each.pixel_size) for each in topographies.values())
    scale = float(spacing)
    if scale_nm is not None:
        scale = 1e-9 * checked_number("scale_nm", scale_nm, unit="nm")
    if scale < spacing * (1.0 - 1e-9):
        raise ValueError(f"scale_nm is {scale_nm}; allowed: {1e9 * spacing:.6g} or more")
    moments = {name: _moments(name, each, scale) for name, each in topographies.items()}
    moments["equivalent"] = np.sum([*moments.values()], axis=0)
    m_0, m_2, m_4 = np.transpose([*moments.values()])
    table = pd.DataFrame(
        {
            "roughness": np.sqrt(m_0),
            "summit_density": m_4 / (6.0 * np.sqrt(3.0) * np.pi * m_2),
            "summit_radius": 0.375 * np.sqrt(np.pi / m_4),
            "slope": np.sqrt(m_2),
            "curvature": np.sqrt(m_4),
            "scale": scale,
        },
        index=[*moments],
    )
    warn_outside({"roughness": table["roughness"]}, {"roughness": (*AXES["roughness"].usual, "m")})
    _warn_if_steep(table["slope"].max())
    return table


def surface_parameters(table: pd.DataFrame, parameters: Parameters | None = None) -> Parameters:
    """Inputs of the model with the summits of a measured surface.

    At another roughness than that of the surface, summits follow the power laws of the inputs.

    Parameters
    ----------
    table : pandas.DataFrame
        The result of ``thirdbody.lab.surface``, of which the row ``equivalent`` is used.
    parameters : Parameters, optional
        The other inputs, by default the calibrated ones.

    Returns
    -------
    Parameters
        With these summits, also in all members.

    Raises
    ------
    ValueError
        For summits out of bounds, as of an eta_s R sigma of 0.0193 or less.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> rough = 100.0 * np.random.default_rng(1).standard_normal((64, 64))  # [nm]
    >>> table = tb.lab.surface(rough, spacing_nm=1000)
    >>> roughness = table.loc["equivalent", "roughness"]
    >>> summits = tb.lab.surface_parameters(table).surface(roughness)
    >>> bool(np.isclose(summits.summit_radius, table.loc["equivalent", "summit_radius"]))
    True
    """
    measured = table.loc["equivalent"]
    summit_parameter = float(measured[["roughness", "summit_density", "summit_radius"]].prod())
    return or_calibrated(parameters).changed(
        reference_roughness=float(measured["roughness"]),
        summit_radius=float(measured["summit_radius"]),
        summit_parameter=summit_parameter,
        **mccool_summits(summit_parameter),
    )


def _topography(name, given, spacing_nm, options):
    """A topography in metres; missing points are interpolated."""
    from SurfaceTopography import Topography, read_topography

    if isinstance(given, str | PathLike):
        given = read_topography(str(given), **options)
    elif isinstance(given, np.ndarray):
        if spacing_nm is not None:
            sizes = np.multiply(given.shape, checked_number("spacing_nm", spacing_nm, unit="nm"))
            options = dict(physical_sizes=tuple(sizes), unit="nm", **options)
        given = Topography(given, **options)
    if given.unit is None:
        raise ValueError(f'{name} has no length unit; allowed: one, as unit="um"')
    if not given.is_uniform:
        raise ValueError(f"the points of {name} are not evenly spaced; allowed: evenly spaced ones")
    given = given.to_unit("m")
    if given.has_undefined_data:
        given = given.interpolate_undefined_data_with_harmonic_function()
    return given


def _without_form(name, topography, form):
    """A topography without its ``form``; warns of a parabola that is left in it."""
    if form not in FORMS:
        raise ValueError(f"form is {form!r}; allowed: {', '.join(FORMS)}")
    rough = topography.detrend(FORMS[form])
    variance = np.var(rough.heights())
    explained = variance - np.var(topography.detrend("curvature").heights())
    if explained > MOST_FORM * variance:
        warnings.warn(
            f"a parabola explains {100.0 * explained / variance:.0f} % of the variance of the heights of "
            f"{name}, probably the form of the body or a tilt; form='curvature' subtracts it",
            OutOfRangeWarning,
            stacklevel=3,
        )
    return rough


def _warn_if_steep(slope):
    """Warn of slopes that no machined surface has, with the likely reason."""
    if slope <= STEEPEST:
        return
    factor = next((each for each in (1e-3, 1e-6, 1e-9) if each * slope <= STEEPEST), 1e-9)
    warnings.warn(
        f"the root mean square slope is {slope:.3g}; usual: at most {STEEPEST:g}. Heights are probably "
        f"in a smaller unit than lengths (height_scale_factor={factor:g}), or a number marks missing points",
        OutOfRangeWarning,
        stacklevel=3,
    )


def _moments(name, topography, scale):
    """Mean squares of heights, slopes and curvatures of profiles, in all directions of the points."""

    def mean_square(*derivatives):
        return np.mean([np.mean(each**2) for each in derivatives if each is not None])

    taken = topography.scale_dependent_statistical_property
    slope, curvature = (
        float(taken(mean_square, n=order, distance=order * scale)[1]) for order in (1, 2)
    )
    moments = np.array([np.var(topography.heights()), slope, curvature])
    if not (np.isfinite(moments).all() and moments.min() > 0.0):
        message = f"{name} has no slopes or curvatures over {1e9 * scale:g} nm"
        raise ValueError(f"{message}; allowed: rough surfaces of more points than that")
    return moments
