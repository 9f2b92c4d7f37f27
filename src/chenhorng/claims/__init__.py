"""The statements of the paper, judged.

``claims`` reads them; ``claim`` and ``kinds`` check them on curves solved by ``evidence``, with
``courses`` and ``between_curves``; ``judge`` does so for any inputs; ``departures`` takes each
departure from the print back; ``verdicts`` makes tables and pages.  Start with ``claims``, then
``judge``.
"""
