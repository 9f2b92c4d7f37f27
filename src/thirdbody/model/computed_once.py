"""Properties that are computed when they are first read, and kept, without a lock.

``functools.cached_property`` of Python 3.11 holds a lock while it computes, one for all objects of
a class.  A process that is forked meanwhile, while another thread solves, gets it locked for good.
"""

from __future__ import annotations


class computed_once:
    """Make a property of a method; two threads that read it first may both compute it.

    Examples
    --------
    >>> class Square:
    ...     side = 3.0
    ...
    ...     @computed_once
    ...     def area(self):
    ...         print("computed")
    ...         return self.side**2
    >>> square = Square()
    >>> square.area, square.area
    computed
    (9.0, 9.0)
    """

    def __init__(self, compute):
        self.compute = compute
        self.__doc__ = compute.__doc__

    def __get__(self, instance, owner=None):
        if instance is None:
            return self
        value = self.compute(instance)
        vars(instance)[self.compute.__name__] = value  # where it is found before this is called
        return value
