"""Reading and judging configuration.

Imports ``thirdbody.model.parameters``.
"""
