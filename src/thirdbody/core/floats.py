"""Limits of float64."""

import numpy as np

EPSILON = np.finfo(float).eps  # relative spacing of numbers
TINY = np.finfo(float).tiny  # below it numbers lose digits
LEAST = 5e-324  # smallest positive number: the spacing below TINY
