"""Time, true error and behaviour at extremes, by which users choose a call and ``rtol``.

``snakemake -c2 accuracy`` runs it.  ``points``, ``accuracy``, ``extremes`` and ``oracle`` measure
true errors, ``classes`` and ``uses`` times, beside a plain solver (``baselines``).  Only the public
interface of the library is measured.
"""
