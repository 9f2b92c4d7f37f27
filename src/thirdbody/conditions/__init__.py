"""The five conditions as they are given: numbers, quantities with units, arrays with named dimensions.

``in_si`` checks and converts them, ``checks`` has what other functions check too, ``labelled`` broadcasts
arrays of xarray by name, and ``usual`` warns of values beyond real interfaces.  May import
``thirdbody.model``; ``thirdbody.solver`` and the packages above it use it where users call them.
"""
