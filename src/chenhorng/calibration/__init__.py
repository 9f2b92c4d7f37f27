"""The unprinted inputs, found from the statements of the paper: ``search``, ``results``, ``choice``
and ``adoption``.
"""
