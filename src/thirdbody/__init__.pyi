from thirdbody.answers.interface import Interface as Interface
from thirdbody.bearings import Material as Material
from thirdbody.bearings import bearing as bearing
from thirdbody.conditions import OutOfRangeWarning as OutOfRangeWarning
from thirdbody.core.parameters import Parameters as Parameters
from thirdbody.core.parameters import mccool_summits as mccool_summits
from thirdbody.grids import grid as grid
from thirdbody.grids import stream as stream
from thirdbody.inputs import ensemble as ensemble
from thirdbody.inputs import load_parameters as load_parameters
from thirdbody.lab.comparison import compare as compare
from thirdbody.lab.estimates import Assumed as Assumed
from thirdbody.lab.oil import cleanliness as cleanliness
from thirdbody.lab.oil import oil_viscosity as oil_viscosity
from thirdbody.lab.roughness import equivalent_roughness as equivalent_roughness
from thirdbody.lab.topography import surface as surface
from thirdbody.paper.atlas.catalogue import open_atlas as open_atlas
from thirdbody.plotting.plot import plot as plot
from thirdbody.points import Solution as Solution
from thirdbody.points import solve as solve
from thirdbody.searches import find as find
from thirdbody.searches import transitions as transitions
from thirdbody.searches import turning_point as turning_point
from thirdbody.searches import turning_window as turning_window

__version__: str
