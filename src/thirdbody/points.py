"""``solve``: the contact state of any number of points.  It returns a ``Solution``, which becomes a
dataset or a table.

Only these two import xarray, pandas and netCDF4, because the import takes longer than solving.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np
from numpy.typing import NDArray

from thirdbody.bearings import hardness_notes
from thirdbody.conditions import (
    ConditionArguments,
    broadcast_by_name,
    check_rtol,
    checked_variables,
    indexed,
    read_conditions,
)
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import (
    FLAG_MEANINGS,
    NO_FLAG,
    STATES,
    codes_to_name,
    states_of,
)
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.ensembles import MEMBER, Ensemble, differing
from thirdbody.inputs import or_calibrated
from thirdbody.notes import area_note, layer_notes, note_lines, outside_notes, ratios_note
from thirdbody.progress import progress_bar
from thirdbody.variables import (
    CONDITIONS,
    ERROR_BOUND,
    FLAGS,
    NORMAL_LOAD,
    QUANTITIES,
    VARIABLES,
    with_table,
)
from thirdbody.version import current

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

SOLVED = (*QUANTITIES, *FLAGS, ERROR_BOUND.name)
POINT = "point"  # a dimension along which several conditions vary, or no condition


@with_table
def solve(
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    rtol: float = DEFAULT_RTOL,
    variables: str | Collection[str] | None = None,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> Solution:
    """Contact state of the interface at each point, by Equations 1 to 10.

    Pass each of the five conditions once, under one of its two names.  They broadcast against each
    other.  The default speed is that of ``parameters``.  A condition is a number or an array of
    numpy, a list of numbers, a column of pandas, an array of xarray or a quantity of pint.  Numbers
    are in the unit of the name.  Quantities, and arrays of xarray with the attribute ``units``, are
    converted.

    Parameters
    ----------
    {conditions}
    parameters : Parameters or Ensemble, optional
        Materials, geometry and interpretations of the model, by default the calibrated inputs.
    members : bool
        Whether all members of an ensemble are solved, by default only the best.  A call with 30
        members takes 30 times as long.
    rtol : float
        Requested relative error of every variable [1], from 1e-11 to 1e-2.  A larger error saves
        little time here, but much in ``grid``.
    variables : str or collection of str, optional
        Names of the variables to keep, by default all variables of ``Solution``.
    progress : bool
        Whether a long call shows a progress bar, on standard error if it is a terminal.

    Returns
    -------
    Solution
        Arrays of the broadcast shape.  If conditions are arrays of xarray, they broadcast by the
        names of their dimensions, and the results are arrays of xarray.  If conditions are columns
        of pandas, which must have equal indexes, tables have their index.  With ``members`` the
        first dimension is ``member``, the best first.  The range is a quantile over it:
        ``solution.to_dataset()["separation"].quantile((0.05, 0.95), "member")``.

    Raises
    ------
    ValueError
        For a condition of another type, a condition that is missing or given twice, a negative,
        infinite or missing number, a load or roughness of 0, a quantity of another dimension, and
        shapes that do not broadcast.  For a roughness outside 1e-30 to 1e30 m, or a roughness at
        which ``parameters`` lift the summits too high.  For particles so soft that the
        ``elastic_factor`` of ``parameters`` is above 1.  For a speed with ``Parameters``, because
        they do not say the density of the oil.

    Warns
    -----
    OutOfRangeWarning
        Once, for numbers outside their usual ranges, which are probably in another unit.

    Notes
    -----
    The roughness of two surfaces is sqrt(Rq_1^2 + Rq_2^2).  The particle size x_a
    is a label: ``parameters`` say what the mean of the sizes and the largest are, over x_a.  The
    speed of a disc under a ball that does not turn is twice the entrainment speed (u_1 + u_2)/2.
    The density of the oil is in the ``setup`` of an ensemble: ``thirdbody.bearing`` sets it, and
    the default is 850 kg/m3.  A load in newtons is the same for all members, though their A_n
    differ.

    Examples
    --------
    Two rough surfaces with particles of 0.5 um, dry and in an oil of 120 mm2/s:

    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter=0.5e-6, roughness_nm=300, particle_density=1e11)
    >>> points = tb.solve(load=1e-5, viscosity_cSt=[0, 120], **layer)
    >>> points.solid_load_fraction.round(4)
    array([1.    , 0.7794])
    >>> points.separation.round(10)  # [m]
    array([1.0560e-06, 1.1968e-06])

    Loads and viscosities with named dimensions give a table:

    >>> import xarray as xr
    >>> loads = xr.DataArray([1e-6, 1e-5], dims="load")
    >>> oils = xr.DataArray([0.0, 120e-6], dims="oil", coords={"oil": ["none", "thick"]})
    >>> points = tb.solve(load=loads, viscosity=oils, **layer)
    >>> points.solid_load_fraction.sel(oil="thick").round(4).values
    array([0.9997, 0.7794])

    The range of the ensemble, from 5 to 95 % of its members:

    >>> points = tb.solve(load_N=10, viscosity_cSt=120, **layer, members=True)
    >>> shares = points.to_dataset()["solid_load_fraction"]
    >>> shares.quantile((0.05, 0.95), "member").round(2).values
    array([0.47, 0.7 ])
    """
    ensemble = or_calibrated(parameters)
    check_rtol(rtol)
    names = checked_variables(variables, SOLVED)
    read = read_conditions(conditions, ensemble.best)
    arrays, pattern = broadcast_by_name(read) if read.labelled else (read.arrays, None)
    sets = ensemble.members if members else (ensemble.best,)
    points = np.broadcast(*arrays.values()).size * len(sets)
    solved = []
    with progress_bar(points, progress) as bar:
        for inputs in sets:
            loaded = read.with_load(inputs, arrays)
            solved_at = ensemble.setup.without_speed(loaded, inputs)
            solved.append(solve_points(solved_at, inputs, rtol, names, bar.update))
    values: dict[str, Any] = {
        name: _stacked([each[name] for each in solved], members) for name in solved[0]
    }
    values |= {name: states_of(name, values[name]) for name in STATES.keys() & values.keys()}
    in_si, given = (
        numbers | {name: array.copy(data=numbers[name]) for name, array in read.labelled.items()}
        for numbers in (read.with_load(ensemble.best), read.given)
    )
    if pattern is not None:
        stacked = pattern.expand_dims({MEMBER: len(sets)}) if members else pattern
        values |= {name: stacked.copy(data=array).rename(name) for name, array in values.items()}
    return Solution(
        variables=values,
        conditions=in_si,
        keys=read.keys,
        given=given,
        parameters=ensemble,
        has_members=members,
        index=read.index,
    )


def _stacked(arrays: list[NDArray], members: bool) -> NDArray:
    """The array of the best set; with ``members`` all arrays, along a new first dimension."""
    return np.stack(arrays) if members else arrays[0]


class Variables:
    """The variables of a ``Solution``, for type checkers and editors: arrays of numpy or of
    xarray."""

    total_contact_area: Any
    particle_contact_area_ratio: Any
    surface_contact_area_ratio: Any
    solid_load_fraction: Any
    fluid_load_fraction: Any
    separation: Any
    film_thickness: Any
    lubrication_regime: Any
    contact_mode: Any
    solution_status: Any
    error_bound: Any


@with_table
@dataclass(frozen=True, eq=False, kw_only=True)
class Solution(Variables):
    """Solved points, the result of ``solve``.

    Every variable is an attribute: an array of the broadcast shape of the conditions, of xarray if
    a condition is.  Points without solution have nan, and ``without_values`` for regime and mode.
    In a full film hardly anything touches, and the mode says little: tables and the printed form
    show no mode.

    Regime, mode and status are texts, ``LubricationRegime``, ``ContactMode`` and ``SolutionStatus``
    of ``thirdbody.core.regimes``: ``solution.contact_mode == "hybrid"``.  Comparison with what is
    no name raises ``ValueError``; ``int`` gives the code in files.  ``error_bound`` is the change
    of loads and areas between two separations, at which the forces are too large and too small,
    plus rounding.  If it is above the requested ``rtol``, the status is ``not_converged``, and the
    values are kept.

    Attributes
    ----------
    {variables}
    variables : mapping
        The requested variables by name.
    conditions : mapping
        The conditions by name, SI: arrays that broadcast to the shape.  A load in newtons becomes
        F_t* of the best set, also with members.
    keys : mapping
        The name of each condition in tables: the name in the call, for a quantity the name with an
        engineering unit.
    given : mapping
        The conditions in the units of ``keys``, as they were given.
    parameters : Ensemble
        The inputs.
    has_members : bool
        Whether the first dimension is ``member``.
    index : pandas.Index, optional
        The index of the columns of pandas among the conditions.
    """

    variables: Mapping[str, Any]
    conditions: Mapping[str, Any]
    keys: Mapping[str, str]
    given: Mapping[str, Any]
    parameters: Ensemble
    has_members: bool = False
    index: pd.Index | None = None

    if not TYPE_CHECKING:  # type checkers accept only the names in ``Variables``

        def __getattr__(self, name: str) -> Any:
            try:
                return vars(self)["variables"][name]
            except KeyError:
                raise AttributeError(f"{name} was not requested, or is no variable") from None

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *self.variables])

    def to_dataset(self) -> xr.Dataset:
        """The points as a dataset with the names, units and symbols of variables and conditions.

        Returns
        -------
        xarray.Dataset
            The requested variables; regime, mode and status are names.  The conditions [SI] and
            ``normal_load`` [N] are coordinates, and conditions under the alias by which they were
            given: ``dataset.sel(load_N=10)``.  A dimension along which a single condition varies
            has the name of this condition, others are called ``point``.  Arrays of xarray keep
            their dimensions, and coordinates that no condition has the name of.  The index of
            columns of pandas becomes a coordinate with its name, or ``row``.  With members the
            first dimension is ``member``; for loads in newtons, the coordinate ``load`` is then
            F_t* of the best.  Attributes have the version and the inputs: ``model_parameters``.

        Examples
        --------
        >>> import numpy as np
        >>> import thirdbody as tb
        >>> curves = tb.solve(
        ...     load=np.geomspace(1e-6, 1e-4, 5)[:, np.newaxis],
        ...     viscosity=[0.0, 90e-6],
        ...     particle_diameter=3e-7,
        ...     roughness=3e-7,
        ...     particle_density=1e11,
        ...     parameters=tb.load_parameters(),
        ... )
        >>> dataset = curves.to_dataset()
        >>> dict(dataset.sizes)
        {'load': 5, 'viscosity': 2}
        >>> dataset["separation"].attrs["units"]
        'm'
        """
        return labelled_dataset(self)

    def to_dataframe(self) -> pd.DataFrame:
        """The points as a table with a row for each point, the conditions first.

        Returns
        -------
        pandas.DataFrame
            Conditions have the names in the call, such as ``load_N``.  Variables have the names in
            ``Solution``, with the SI unit at the end if there is one: ``separation_m``.  Others are
            ratios [1].  ``attrs["notes"]`` says to what: areas to A_n, the film thickness to R_x;
            which conditions the paper has not; and what x_a stands for.  Flags are categories by
            name, nan where a point has no state.  The index is that of the columns of pandas, if
            conditions are such columns.

        Examples
        --------
        >>> import thirdbody as tb
        >>> points = tb.solve(
        ...     load=[1e-6, 1e-4],
        ...     viscosity=90e-6,
        ...     particle_diameter=3e-7,
        ...     roughness=3e-7,
        ...     particle_density=1e11,
        ...     parameters=tb.load_parameters(),
        ... )
        >>> table = points.to_dataframe()
        >>> table[["load", "lubrication_regime"]].to_dict("list")
        {'load': [1e-06, 0.0001], 'lubrication_regime': ['boundary', 'mixed']}
        """
        return labelled_frame(self)

    def __repr__(self) -> str:
        arrays = {name: np.asarray(array) for name, array in self.variables.items()}
        shape = next(iter(arrays.values())).shape if arrays else ()
        arrays |= codes_to_name(arrays)
        lines = [f"{name:<28}{_in_words(name, array)}" for name, array in arrays.items()]
        return "\n".join([f"Solution of shape {shape}", *lines, note_lines(_notes(self))])

    def _repr_html_(self) -> str:
        return self.to_dataframe().to_html(index=self.index is not None, max_rows=60)


def _in_words(name: str, values: NDArray) -> str:
    """The text of a number or of the range of numbers; of a flag the names with their counts."""
    if name in STATES:
        codes, counts = np.unique(values, return_counts=True)
        states = np.where(codes == NO_FLAG, "none", states_of(name, codes))
        if values.size == 1:
            return states[0]
        return ", ".join(f"{state} ({count})" for state, count in zip(states, counts, strict=True))
    numbers = values[~np.isnan(values)]
    if numbers.size == 0:
        return "none"
    variable, unit = VARIABLES[name], ""
    if variable.unit != "1":
        numbers, unit = variable.from_si(numbers), f" {variable.shown_unit}"
    ends = f"{numbers.min():.6g}", f"{numbers.max():.6g}"
    return (ends[0] if values.size == 1 else " to ".join(ends)) + unit


def _notes(solution: Solution) -> list[str]:
    """The notes on all points together."""
    parameters, given = solution.parameters, {}
    for name, values in solution.conditions.items():
        given[CONDITIONS[name].alias] = CONDITIONS[name].from_si(np.asarray(values))
    given["load_N"] *= parameters.newtons_per_load
    return [
        *outside_notes(given, or_calibrated(None).speed),
        *hardness_notes(given["load_N"], parameters),
        area_note(parameters),
        ratios_note(parameters),
        *layer_notes(given, parameters.best),
    ]


def labelled_dataset(solution: Solution) -> xr.Dataset:
    """The dataset of a solution, as in ``Solution.to_dataset``."""
    from thirdbody.netcdf import attributes_of, finished

    dataset = _with_rows(_labelled(solution), solution.index)
    roughness = dataset["roughness"]
    is_axis = roughness.dims in ((), ("roughness",))
    surfaces = np.atleast_1d(roughness.values) if is_axis else None
    ensemble = solution.parameters
    known = differing(ensemble) if solution.has_members else {}
    known |= {"title": "Three-body contact at points", "software_version": current().text}
    return finished(dataset.assign_attrs(attributes_of(ensemble.best, surfaces, **known)))


def _labelled(solution: Solution) -> xr.Dataset:
    import xarray as xr

    from thirdbody.netcdf import alias_attributes, coordinate_attributes, described_variable

    variables, conditions = solution.variables, solution.conditions
    first = next(iter(variables.values()), None)
    labelled = first if isinstance(first, xr.DataArray) else None
    plain = [values for values in conditions.values() if not isinstance(values, xr.DataArray)]
    shape = np.broadcast_shapes(*map(np.shape, (*variables.values(), *plain)))
    of_points = shape[1:] if solution.has_members else shape
    names = [MEMBER] if solution.has_members else []
    names += _dimensions(of_points, conditions) if labelled is None else []
    dimensions = names if labelled is None else labelled.dims
    coordinates = {} if labelled is None else dict(labelled.coords)
    ensemble = solution.parameters
    single = None if solution.has_members else ensemble.best
    if solution.has_members:
        coordinates[MEMBER] = MEMBER, np.arange(len(ensemble.members))
    for name, values in conditions.items():
        key, axis = solution.keys[name], CONDITIONS[name]
        attributes = coordinate_attributes(axis, single)
        coordinates[name] = *_placed(values, dimensions, shape), attributes
        if key != name:
            given = _placed(solution.given[name], dimensions, shape)
            coordinates[key] = *given, alias_attributes(axis, single)
    described = {
        name: described_variable(name, dimensions, np.asarray(values))
        for name, values in variables.items()
    }
    dataset = xr.Dataset(described, coordinates)
    newtons = dataset["load"].variable * ensemble.newtons_per_load
    if solution.has_members and solution.keys["load"] != "load_N":  # newtons differ by member
        per_load = [member.newtons_per_load for member in ensemble.members]
        newtons = xr.Variable(MEMBER, per_load) * dataset["load"].variable
    newtons.attrs = coordinate_attributes(NORMAL_LOAD)
    return dataset.assign_coords(normal_load=newtons)


def labelled_frame(solution: Solution) -> pd.DataFrame:
    """The table of a solution, as in ``Solution.to_dataframe``."""
    import pandas as pd

    dataset = _labelled(solution)
    flat = dataset if dataset.sizes else dataset.expand_dims(POINT)
    codes = codes_to_name({name: flat[name] for name in solution.variables})
    flat = flat.assign({name: flat[name].copy(data=values) for name, values in codes.items()})
    labels = [name for name in flat.dims if name in flat.coords]
    others = [name for name in flat.coords if name not in labels]
    frame = flat.to_dataframe().reset_index()[[*labels, *others, *solution.variables]]
    for name in codes:
        frame[name] = pd.Categorical.from_codes(frame[name], FLAG_MEANINGS[name])
    headings = {name: column_name(name) for name in solution.variables}
    headings |= solution.keys
    for name, key in solution.keys.items():
        if key != name:
            frame[name] = frame.pop(key)
    headings[NORMAL_LOAD.name] = "load_N"
    if solution.keys["load"] == "load_N":
        frame = frame.drop(columns=NORMAL_LOAD.name)
    frame = frame.rename(columns=headings)
    frame.attrs["notes"] = _notes(solution)
    return indexed(frame, solution.index, range(len(frame)))


def column_name(variable: str) -> str:
    """The name of a variable in tables, with the unit at the end if there is one."""
    unit = VARIABLES[variable].unit
    return variable if unit == "1" else f"{variable}_{unit}"


def _with_rows(dataset, index):
    """A dataset with the levels of ``index`` as coordinates along its last dimension.

    A level without a name is called ``row``.  Objects become text, as netCDF has no such type.  The
    dataset is unchanged if ``index`` is None.
    """
    if index is None:
        return dataset
    dimension, size = [*dataset.sizes.items()][-1]
    rows = index.take(np.arange(size) % max(len(index), 1))
    labels: dict[str, tuple] = {}
    for level, name in enumerate(rows.names):
        if name is None or name in (*dataset.variables, *labels):
            name = "row" if rows.nlevels == 1 else f"row_{level}"
        values = np.asarray(rows.get_level_values(level))
        labels[str(name)] = dimension, values.astype(str) if values.dtype == object else values
    return dataset.assign_coords(labels)


def _dimensions(shape: tuple[int, ...], conditions: Mapping[str, Any]) -> list[str]:
    """The names of the dimensions of points.

    A dimension has the name of a condition if only this condition varies along it, and along no
    other dimension.
    """
    varying = [
        [name for name, values in conditions.items() if axis in _axes(np.shape(values), shape)]
        for axis in range(-len(shape), 0)
    ]
    along = [name for names in varying for name in names]
    owners = [
        names[0] if len(names) == 1 and along.count(names[0]) == 1 else None for names in varying
    ]
    if owners.count(None) == 1:
        return [name or POINT for name in owners]
    return [name or f"{POINT}_{axis}" for axis, name in enumerate(owners)]


def _placed(values, dimensions, shape):
    """Dimensions and values of a condition; dimensions along which it is constant are removed."""
    import xarray as xr

    if isinstance(values, xr.DataArray):
        return values.dims, values.values
    axes = _axes(np.shape(values), shape)
    repeated = tuple(axis for axis in range(-np.ndim(values), 0) if axis not in axes)
    return [dimensions[axis] for axis in axes], np.squeeze(values, repeated)


def _axes(sizes: tuple[int, ...], shape: tuple[int, ...]) -> list[int]:
    """The axes, counted from the end, whose length in ``sizes`` is that in ``shape``."""
    return [axis for axis in range(-len(sizes), 0) if sizes[axis] == shape[axis]]
