"""The explorer: a web page that shows the figures of the paper and evaluates its equations.

Of the scripts in ``web/``, ``model.js`` has the equations, ``curves.js`` curves over the load,
``rig.js`` what follows from materials, speed and oil, and ``ranges.js`` the ranges of the ensemble;
the others display them. Start with ``build.page_text``.
"""
