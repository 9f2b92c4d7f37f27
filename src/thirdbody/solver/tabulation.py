"""Piecewise polynomials that stand in for a smooth function of one variable."""

from __future__ import annotations

from copy import copy

import numpy as np


class PiecewisePolynomial:
    """Value and slope of ``function`` from its interpolant on equal pieces of ``[start, end]``.

    ``function(x)`` returns (value, slope) for a 1-D array; so does an instance, for arrays of any
    shape.  Each piece interpolates at Chebyshev points.  Outside the interval, and for nan, the
    function itself is evaluated, so that an instance is as widely valid as what it tabulates.
    ``error`` is the largest in the middle of a piece, which for an odd degree is about the largest
    there is.  ``values`` are those at ``sample_points``, if they are known.
    """

    def __init__(self, function, start: float, end: float, pieces: int, degree: int, values=None):
        self.function = function
        self.start = start
        self.end = end
        self.pieces = pieces
        self.degree = degree
        self.scale = pieces / (end - start)
        x = sample_points(start, end, pieces, degree)
        if values is None:
            values = function(x)[0]
        *at_nodes, middle = values.reshape(pieces, degree + 2).T
        self.centres = x[degree + 1 :: degree + 2]
        # local variable 2(x - centre)/width in [-1, 1]
        self.coefficients = interpolants(at_nodes)
        self.error = float(np.abs(self(self.centres)[0] - middle).max())

    def __call__(self, x):
        """(value, slope) at ``x``, each of its shape."""
        return self.evaluated(x, 0, lambda beyond, _: self.function(beyond))

    def evaluated(self, x, member, function):
        """(value, slope) at ``x``, of joined polynomials those of the ``member`` of each element.

        ``member`` is an index, or one for each element of the last axes of ``x``.  Outside the
        interval it is ``function(x, member)`` of these elements.
        """
        position, inside = self.located(x)
        if inside.all():
            return self.interpolate(position, member)
        value = np.empty_like(position)
        slope = np.empty_like(position)
        for chosen, evaluate, places in (
            (inside, self.interpolate, position),
            (~inside, function, x),
        ):
            some = member
            if np.ndim(member):
                some = np.broadcast_to(member, x.shape)[chosen]
            value[chosen], slope[chosen] = evaluate(places[chosen], some)
        return value, slope

    @classmethod
    def joined(cls, members) -> PiecewisePolynomial:
        """The polynomials of ``members``, all on the same pieces, side by side: for ``evaluated``."""
        together = copy(members[0])
        together.coefficients = np.hstack([member.coefficients for member in members])
        return together

    def located(self, x):
        """Where ``x`` is, in pieces from the start, and whether it is in the interval."""
        position = (x - self.start) * self.scale
        return position, (position >= 0.0) & (position < self.pieces)

    def interpolate(self, position, member=0):
        """(value, slope) at a ``position`` in the interval; of several, those of a ``member``."""
        piece = position.astype(np.intp)
        local = 2.0 * (position - piece) - 1.0
        piece = piece + member * self.pieces
        value = self.coefficients[-1].take(piece)
        slope = np.zeros_like(value)
        for row in self.coefficients[-2::-1]:
            slope *= local
            slope += value
            value *= local
            value += row.take(piece)
        slope *= 2.0 * self.scale
        return value, slope


def chebyshev_points(degree: int):
    """The ``degree`` + 1 places within [-1, 1] at which a polynomial interpolates best."""
    return np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))


def interpolants(at_nodes):
    """Coefficients of the polynomials that go through values at ``chebyshev_points``.

    ``at_nodes`` has a row for each of those and a column for each piece; row k of the result holds
    the coefficients of the k-th power.
    """
    nodes = chebyshev_points(len(at_nodes) - 1)
    return np.ascontiguousarray(np.linalg.solve(np.vander(nodes, increasing=True), at_nodes))


def sample_points(start: float, end: float, pieces: int, degree: int):
    """Where a ``PiecewisePolynomial`` needs the values of its function, 1-D: the Chebyshev points
    of each piece, and then its middle."""
    scale = pieces / (end - start)
    centres = start + (np.arange(pieces) + 0.5) / scale
    return (centres[:, None] + 0.5 * np.append(chebyshev_points(degree), 0.0) / scale).ravel()
