from .bearings import bearing as bearing
from .conditions import OutOfRangeWarning as OutOfRangeWarning
from .core.parameters import Parameters as Parameters
from .ensembles import Ensemble as Ensemble
from .ensembles import Material as Material
from .ensembles import Setup as Setup
from .grids import grid as grid
from .grids import stream as stream
from .inputs import ensemble as ensemble
from .inputs import load_parameters as load_parameters
from .plotting.plot import plot as plot
from .points import Solution as Solution
from .points import solve as solve
from .searches import find as find
from .searches import transitions as transitions
from .searches import turning_point as turning_point
from .searches import turning_window as turning_window

__version__: str
