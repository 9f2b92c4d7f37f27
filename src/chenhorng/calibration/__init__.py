"""The calibration of the unprinted inputs on the statements of the paper.

``calibration`` defines the objective.  ``searches`` lists the searches, and ``search`` runs them.
``results`` summarises them, ``choice`` chooses the default, and ``adoption`` writes its files.
"""
