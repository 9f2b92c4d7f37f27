"""The paper's equations and nothing else.

Imports numpy, scipy.special and nothing of the other rooms.
"""
