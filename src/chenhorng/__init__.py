"""The paper, as the workflow computes it with the library.  The library imports nothing of this
package.

``configuration`` checks the settings.  ``scenes`` makes the datasets of figures.  ``extraction``,
``tables`` and ``sheets`` make tables.  ``ensemble_range`` and ``sensitivity`` compute how results
depend on the inputs.  ``claims`` judges the statements of the paper, and ``calibration`` searches
the unprinted inputs.  ``figures`` draws, ``page`` makes the explorer, ``archive`` makes the
release, and ``atlas`` opens the solved space of conditions.
"""
