"""The calibration of the unprinted inputs on the statements of the paper.

``calibration`` defines the objective.  ``searches`` lists the searches, and ``search`` runs them.
``profile`` shows what the statements determine.  ``results`` summarises the searches, ``choice``
chooses the default, and ``adoption`` writes its files.
"""
