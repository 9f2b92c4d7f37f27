"""What measures the library: the errors that it makes and the time that it takes.

Errors are taken at points known in multiple precision (``points``, ``errors``, ``extremes``) and in all
readings against the implementation in extended precision of ``tests/oracle`` (``oracle``), times for
random points of several classes (``classes``, ``times``, ``scaling``, ``omissions``,
``starts``, ``streams``), and both are compared with two simpler ways of solving (``baselines``) and
with what the solver is to achieve (``bars``); ``archive`` makes a dataset of them.  Two programs
measure by themselves: ``measure_overhead`` and ``measure_compression``.  The folder stands beside
the package and may import all of it; the package imports nothing from here.  Begin with
``times.time_rows`` and ``errors.error_rows``.
"""
