"""What users choose by: time, true error, and behaviour at extremes.

``snakemake -c2 accuracy`` runs it.  True errors come from points known in multiple precision (``points``,
``accuracy``, ``extremes``) and from the oracle in extended precision (``oracle``).  Times are those of random points
and grids (``classes``, ``accuracy``) and of typical uses (``uses``).  Two simpler solvers run beside the library
(``baselines``), and ``targets`` compares the results with what the library should reach.  ``compare_runs`` compares
two runs of the workflow.  Only the public interface of the library is measured.
"""
