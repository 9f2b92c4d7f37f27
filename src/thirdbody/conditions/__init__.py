"""The five conditions as given: numbers, quantities with units, arrays with named dimensions.

``in_si`` checks and converts them, ``checks`` has checks shared with other functions, ``labelled``
broadcasts arrays of xarray by name, and ``usual`` warns of values outside real interfaces.  May
import ``thirdbody.model``.  ``thirdbody.solver`` and the packages above use it in public functions.
"""
