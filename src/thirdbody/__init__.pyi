from thirdbody.answers.bearing import Material as Material
from thirdbody.answers.bearing import bearing as bearing
from thirdbody.answers.find import find as find
from thirdbody.answers.find import transitions as transitions
from thirdbody.answers.find import turning_point as turning_point
from thirdbody.answers.find import turning_window as turning_window
from thirdbody.answers.interface import Interface as Interface
from thirdbody.atlas.catalogue import open_atlas as open_atlas
from thirdbody.conditions import OutOfRangeWarning as OutOfRangeWarning
from thirdbody.configuration.inputs import ensemble as ensemble
from thirdbody.configuration.inputs import load_parameters as load_parameters
from thirdbody.core.parameters import Parameters as Parameters
from thirdbody.core.parameters import mccool_summits as mccool_summits
from thirdbody.data.dataset import grid as grid
from thirdbody.data.dataset import stream as stream
from thirdbody.figures.plot import plot as plot
from thirdbody.measured.comparison import compare as compare
from thirdbody.measured.estimates import Assumed as Assumed
from thirdbody.measured.oil import cleanliness as cleanliness
from thirdbody.measured.oil import oil_viscosity as oil_viscosity
from thirdbody.measured.roughness import equivalent_roughness as equivalent_roughness
from thirdbody.measured.topography import surface as surface
from thirdbody.points import Solution as Solution
from thirdbody.points import solve as solve

__version__: str
