"""The five conditions as given: numbers, quantities with units, arrays with named dimensions.

``in_si`` converts them and broadcasts arrays of xarray by name; ``checks`` has checks of arguments
and the warning of unusual numbers.  May import ``thirdbody.model``.
"""
