"""The explorer: a web page that shows the figures of the paper and evaluates its equations.

In ``web/``, ``model.js`` has the equations, and ``curves.js`` computes curves over the load.
``rig.js`` computes inputs from materials, speed and oil, and ``ranges.js`` computes the ranges of
the ensemble.  The other scripts display the results.  Start with ``build.page_text``.
"""
