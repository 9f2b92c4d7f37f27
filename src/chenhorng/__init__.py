"""The paper: what the workflow computes with the library, which imports nothing of it.

``configuration`` checks the settings, ``scenes`` are the datasets of figures, ``extraction``,
``tables`` and ``sheets`` make tables, ``bands`` and ``sensitivity`` the dependence on the inputs.
``claims`` judges the statements of the paper, ``calibration`` finds the unprinted inputs,
``figures`` draws, ``page`` is the explorer, ``archive`` the release, and ``atlas`` the whole space
of conditions.
"""
