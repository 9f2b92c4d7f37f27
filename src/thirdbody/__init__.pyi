from thirdbody.bearings import Material as Material
from thirdbody.bearings import bearing as bearing
from thirdbody.conditions import OutOfRangeWarning as OutOfRangeWarning
from thirdbody.core.parameters import Parameters as Parameters
from thirdbody.grids import grid as grid
from thirdbody.grids import stream as stream
from thirdbody.inputs import ensemble as ensemble
from thirdbody.inputs import load_parameters as load_parameters
from thirdbody.plotting.plot import plot as plot
from thirdbody.points import Solution as Solution
from thirdbody.points import solve as solve
from thirdbody.searches import find as find
from thirdbody.searches import transitions as transitions
from thirdbody.searches import turning_point as turning_point
from thirdbody.searches import turning_window as turning_window

__version__: str
