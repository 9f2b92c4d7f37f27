"""Piecewise polynomials that stand in for a smooth function of one variable."""

from __future__ import annotations

from copy import copy

import numpy as np


class PiecewisePolynomial:
    """A smooth function and its slope, interpolated on equal pieces of an interval.

    Parameters
    ----------
    function : callable
        Maps a 1-D array to a pair of arrays: the function and its slope.
    start, end : float
        The interval.  Beyond it, and for nan, the function itself is evaluated, so that an
        instance holds wherever the function does.
    pieces : int
        Number of polynomials, each on a piece of the same width.
    degree : int
        Their degree; each goes through the function at ``degree`` + 1 Chebyshev points.
    values : array, optional
        The function at ``sample_points``, if it is known there already.

    Attributes
    ----------
    error : float
        Largest error in the middle of a piece, about the largest anywhere if the degree is odd.

    Examples
    --------
    >>> import numpy
    >>> sine = PiecewisePolynomial(lambda x: (numpy.sin(x), numpy.cos(x)), 0.0, 3.0, 30, 5)
    >>> value, slope = sine(numpy.array([0.5, 40.0]))
    >>> bool(numpy.abs(value - numpy.sin([0.5, 40.0])).max() < 1e-9)
    True
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
        """Value and slope at ``x``, each of its shape."""
        return self.evaluated(x, 0, lambda beyond, _: self.function(beyond))

    def evaluated(self, x, member, function):
        """Value and slope at ``x`` of joined polynomials.

        Parameters
        ----------
        x : array
            Of any shape.
        member : int or array of int
            Which of the joined functions, for all or for each element of the last axes of ``x``.
        function : callable
            ``function(x, member)`` is evaluated for the elements beyond the interval.

        Returns
        -------
        value, slope : array
            Of the shape of ``x``.
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
        """The polynomials of several functions on the same pieces, side by side for ``evaluated``."""
        together = copy(members[0])
        together.coefficients = np.hstack([member.coefficients for member in members])
        return together

    def located(self, x):
        """How many pieces ``x`` is from the start, and whether it is in the interval."""
        position = (x - self.start) * self.scale
        return position, (position >= 0.0) & (position < self.pieces)

    def interpolate(self, position, member=0):
        """Value and slope at a ``position`` of ``located``, within the interval, of a ``member``."""
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
    """The ``degree`` + 1 places in [-1, 1] at which a polynomial of this degree interpolates best."""
    return np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))


def interpolants(at_nodes):
    """Coefficients of the polynomials that go through given values at ``chebyshev_points``.

    Parameters
    ----------
    at_nodes : array, shape (degree + 1, pieces)
        Values at these points, a column for each piece.

    Returns
    -------
    array, shape (degree + 1, pieces)
        Row k holds the coefficients of the k-th power.
    """
    nodes = chebyshev_points(len(at_nodes) - 1)
    return np.ascontiguousarray(np.linalg.solve(np.vander(nodes, increasing=True), at_nodes))


def sample_points(start: float, end: float, pieces: int, degree: int):
    """Where a ``PiecewisePolynomial`` takes its function, 1-D: piece by piece at the Chebyshev points
    and then in the middle, which tells the error."""
    scale = pieces / (end - start)
    centres = start + (np.arange(pieces) + 0.5) / scale
    return (centres[:, None] + 0.5 * np.append(chebyshev_points(degree), 0.0) / scale).ravel()
