from thirdbody.configuration.inputs import load_parameters as load_parameters
from thirdbody.data.dataset import grid as grid
from thirdbody.data.streaming import stream as stream
from thirdbody.model.parameters import Parameters as Parameters
from thirdbody.solver.solution import Solution as Solution
from thirdbody.solver.solve import solve as solve

__version__: str
