"""The statements of the paper, judged.

``claims`` reads the statements.  ``evidence`` solves their curves.  ``claim`` and ``kinds`` check a
statement on its curves, with ``courses`` and ``between_curves``.  ``judge`` checks all statements
for any inputs.  ``departures`` takes each departure from the print back.  ``verdicts`` makes tables
and pages.  Start with ``claims``, then ``judge``.
"""
