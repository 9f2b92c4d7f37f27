"""Piecewise polynomials that stand in for a smooth function of one variable."""

from __future__ import annotations

from copy import copy

import numpy as np

# By how much more than in its middle, where one of the greatest errors is if the degree is odd, a
# polynomial may be wrong elsewhere in its piece: what has been seen is 1.06.
ELSEWHERE = 1.25


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
        Bound on the error, if the degree is odd: ``ELSEWHERE`` times the largest in the middle of a
        piece.

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
        # of powers of the place, of which there is one, and of 2(x - centre)/width in [-1, 1]
        self.coefficients = interpolants(at_nodes)[None]
        self.error = ELSEWHERE * float(np.abs(self(self.centres)[0] - middle).max())

    def __call__(self, x, place=0.0):
        """Value and slope at ``x``, each of its shape; ``place`` is as in ``between``."""
        return self.evaluated(x, 0, place, lambda beyond, _: self.function(beyond))

    @classmethod
    def between(cls, members, middle) -> PiecewisePolynomial:
        """A function that also depends on a variable from -1 to 1, its ``place``.

        Parameters
        ----------
        members : sequence of PiecewisePolynomial
            The function of x at the places ``chebyshev_points``, on the same pieces.
        middle : PiecewisePolynomial
            The function at place 0, which tells the error; the number of members is even.

        Returns
        -------
        PiecewisePolynomial
            A polynomial in the place too.  Beyond the interval it is not defined.
        """
        found = copy(members[0])
        found.function = None
        found.coefficients = interpolants([member.coefficients[0] for member in members])
        x = sample_points(found.start, found.end, found.pieces, found.degree)
        error = np.abs(found.at(0.0)(x)[0] - middle(x)[0]).max()
        found.error = float(error) + max(member.error for member in (*members, middle))
        return found

    def at(self, place: float) -> PiecewisePolynomial:
        """The polynomials of x alone that these are at one ``place``."""
        found = copy(self)
        together = self.coefficients[-1]
        for term in self.coefficients[-2::-1]:
            together = together * place + term
        found.coefficients = together[None]
        return found

    def evaluated(self, x, member, place, function):
        """Value and slope at ``x`` of joined polynomials.

        Parameters
        ----------
        x : array
            Of any shape.
        member : int or array of int
            Which of the joined functions, for all or for each element of the last axes of ``x``.
        place : float or array
            As in ``between``, for all or for each such element.
        function : callable
            ``function(x[chosen], chosen)`` is evaluated for the elements beyond the interval, which
            a mask ``chosen`` tells.

        Returns
        -------
        value, slope : array
            Of the shape of ``x``.
        """
        position, inside = self.located(x)
        if inside.all():
            return self.interpolate(position, member, place)
        value = np.empty_like(position)
        slope = np.empty_like(position)
        some = (
            np.broadcast_to(each, x.shape)[inside] if np.ndim(each) else each
            for each in (member, place)
        )
        value[inside], slope[inside] = self.interpolate(position[inside], *some)
        value[~inside], slope[~inside] = function(x[~inside], ~inside)
        return value, slope

    @classmethod
    def joined(cls, members) -> PiecewisePolynomial:
        """The polynomials of several functions on the same pieces, side by side for ``evaluated``."""
        together = copy(members[0])
        together.coefficients = np.concatenate([each.coefficients for each in members], axis=-1)
        return together

    def located(self, x):
        """How many pieces ``x`` is from the start, and whether it is in the interval."""
        position = (x - self.start) * self.scale
        return position, (position >= 0.0) & (position < self.pieces)

    def interpolate(self, position, member=0, place=0.0):
        """Value and slope at a ``position`` of ``located``, within the interval, of a ``member`` at
        its ``place``."""
        piece = position.astype(np.intp)
        local = 2.0 * (position - piece) - 1.0
        piece = piece + member * self.pieces
        value = self._coefficient(self.degree, piece, place)
        slope = np.zeros_like(value)
        for power in range(self.degree - 1, -1, -1):
            slope *= local
            slope += value
            value *= local
            value += self._coefficient(power, piece, place)
        slope *= 2.0 * self.scale
        return value, slope

    def _coefficient(self, power, piece, place):
        """Coefficients of a power of the place within each ``piece``."""
        value = self.coefficients[-1, power].take(piece)
        for term in self.coefficients[-2::-1, power]:
            value *= place
            value += term.take(piece)
        return value


def chebyshev_points(degree: int):
    """The ``degree`` + 1 places in [-1, 1] at which a polynomial of this degree interpolates best."""
    return np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))


def interpolants(at_nodes):
    """Coefficients of the polynomials that go through given values at ``chebyshev_points``.

    Parameters
    ----------
    at_nodes : array_like, shape (degree + 1, ...)
        Values at these points, for each of any number of polynomials.

    Returns
    -------
    array, shape (degree + 1, ...)
        Element k of the first axis holds the coefficients of the k-th power.
    """
    at_nodes = np.asarray(at_nodes)
    powers = np.vander(chebyshev_points(len(at_nodes) - 1), increasing=True)
    solved = np.linalg.solve(powers, at_nodes.reshape(len(at_nodes), -1))
    return np.ascontiguousarray(solved.reshape(at_nodes.shape))


def sample_points(start: float, end: float, pieces: int, degree: int):
    """Where a ``PiecewisePolynomial`` takes its function, 1-D: piece by piece at the Chebyshev points
    and then in the middle, which tells the error."""
    scale = pieces / (end - start)
    centres = start + (np.arange(pieces) + 0.5) / scale
    return (centres[:, None] + 0.5 * np.append(chebyshev_points(degree), 0.0) / scale).ravel()
