"""``surface``: roughness, and density and radius of the summits, of measured topographies."""

import math
import warnings
from dataclasses import dataclass, replace
from inspect import signature
from os import PathLike
from typing import Any

import numpy as np

from thirdbody.conditions import OutOfRangeWarning, checked_number, warn_outside
from thirdbody.core.parameters import Parameters, mccool_summits
from thirdbody.extras import require
from thirdbody.files import readable_file
from thirdbody.inputs import or_calibrated
from thirdbody.messages import format_path
from thirdbody.tabular import Tabular
from thirdbody.variables import AXES

STEEPEST = 1.0  # root mean square slope


@dataclass(frozen=True)
class MeasuredSurface(Tabular):
    """The equivalent rough surface of one or several measured topographies, SI.

    ``roughness`` is sigma [m], the root mean square height; ``summit_density`` eta_s [m-2] and
    ``summit_radius`` R [m] of the summits; ``slope`` [1] and ``curvature`` [m-1] are root mean
    squares of profiles over the distance ``scale`` [m]. eta_s and R depend on it: at ten times the
    distance, a typical surface has far fewer and blunter summits.
    """

    roughness: float
    summit_density: float
    summit_radius: float
    slope: float
    curvature: float
    scale: float

    def parameters(self, parameters: Parameters | None = None) -> Parameters:
        """Inputs of the model, by default the calibrated ones, with the summits of this surface.

        At another roughness than this one, summits follow the power laws of the inputs.
        """
        summit_parameter = self.summit_density * self.summit_radius * self.roughness
        return replace(
            or_calibrated(parameters),
            reference_roughness=self.roughness,
            summit_radius=self.summit_radius,
            summit_parameter=summit_parameter,
            **mccool_summits(summit_parameter),
        )


def surface(
    *paths: str | PathLike, scale_nm: float | None = None, curved: bool = False, **options: Any
) -> MeasuredSurface:
    """Roughness and summits of a measured topography, or of two in contact (their moments add).

    SurfaceTopography reads the files and computes slopes and curvatures as finite differences over
    one distance in both directions.  From the moments m_0 (heights), m_2 (slopes) and m_4
    (curvatures) of profiles, McCool (1987, J. Tribol. 109:264) has eta_s = m_4/(6 sqrt(3) pi m_2)
    and R = 3 sqrt(pi)/(8 sqrt(m_4)), for isotropic surfaces with Gaussian heights.  Raises
    ``ValueError`` for a file that cannot be read, has no unit or is flat, and for a scale below the
    point spacing; ``OSError`` if there is no such file.

    Parameters
    ----------
    *paths : path
        Files of an instrument, or x, y and z in columns: all formats that SurfaceTopography reads.
    scale_nm : float, optional
        The distance for slopes and curvatures [nm]; by default the largest point spacing of the files.  The
        lateral resolution of instruments is often coarser than the spacing: use the resolution.
    curved : bool
        Whether to subtract a parabola, as for a ball; a tilt is always subtracted.
    **options
        Information missing in a file, as arguments of ``SurfaceTopography.read_topography``:
        ``unit="um"``, ``physical_sizes``, ``height_scale_factor``.

    Examples
    --------
    ::

        pair = tb.surface("ball.xyz", "flat.xyz", scale_nm=1000, unit="um")
        tb.solve(..., roughness=pair.roughness, parameters=pair.parameters())
    """
    require("topography", "SurfaceTopography")
    if not paths:
        raise ValueError("paths is empty; allowed: one file or more")
    _check_options(options)
    topographies = [_read(path, curved, options) for path in paths]
    spacing = max(max(each.pixel_size) for each in topographies)
    scale = float(spacing)
    if scale_nm is not None:
        scale_nm = checked_number("scale_nm", scale_nm, unit="nm")
        scale = 1e-9 * scale_nm
    if scale < spacing * (1.0 - 1e-9):
        raise ValueError(f"scale_nm is {scale_nm:g}; allowed: {1e9 * spacing:.6g} or more")
    found = [_moments(path, each, scale) for path, each in zip(paths, topographies)]
    m_0, m_2, m_4 = np.sum(found, axis=0).tolist()
    roughness = math.sqrt(m_0)
    warn_outside({"roughness": roughness}, {"roughness": (*AXES["roughness"].usual, "m")})
    _warn_if_steep(math.sqrt(m_2))
    return MeasuredSurface(
        roughness=roughness,
        summit_density=m_4 / (6.0 * math.sqrt(3.0) * math.pi * m_2),
        summit_radius=0.375 * math.sqrt(math.pi / m_4),
        slope=math.sqrt(m_2),
        curvature=math.sqrt(m_4),
        scale=scale,
    )


def _check_options(options):
    """``ValueError`` for arguments that no reader has."""
    from SurfaceTopography.IO.Reader import ReaderBase

    known = [name for name in signature(ReaderBase.topography).parameters if name != "self"]
    for name in options:
        if name not in (*known, "format"):
            raise TypeError(f"there is no argument {name}; allowed: {', '.join(known)}")


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


def _read(path, curved, options):
    """A topography in metres, without tilt; missing points are interpolated."""
    from SurfaceTopography import read_topography

    allowed = "paths of files; tb.equivalent_roughness takes numbers"
    path = readable_file("paths", path, allowed)
    try:
        topography = read_topography(str(path), **options)
        if topography.unit is None:
            raise ValueError('it has no length unit; give one, as unit="um"')
        if not topography.is_uniform:
            raise ValueError("its points are not evenly spaced")
        topography = topography.to_unit("m")
        if topography.has_undefined_data:
            topography = topography.interpolate_undefined_data_with_harmonic_function()
        return topography.detrend("curvature" if curved else "height")
    except Exception as error:  # about thirty readers raise different types
        message = " ".join(str(error).split())[:200] or type(error).__name__
        raise ValueError(f"{format_path(path)} cannot be used as a topography: {message}") from None


def _moments(path, topography, scale):
    """Mean squares of heights, slopes and curvatures of profiles, in all directions of the points."""

    def mean_square(*derivatives):
        return np.mean([np.mean(each**2) for each in derivatives if each is not None])

    taken = topography.scale_dependent_statistical_property
    slope, curvature = (
        float(taken(mean_square, n=order, distance=order * scale)[1]) for order in (1, 2)
    )
    found = np.array([np.var(topography.heights()), slope, curvature])
    if not (np.isfinite(found).all() and found.min() > 0.0):
        message = f"{format_path(path)} has no slopes or curvatures over {1e9 * scale:g} nm"
        raise ValueError(f"{message}; allowed: rough surfaces of more points than that")
    return found
