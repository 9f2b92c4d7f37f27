"""What a run of the workflow relies on.

This room knows which modules a script needs, what each product was when it was made, and how a run
comes to be alone in its folder.  It imports the standard library.  ``start`` is what the Snakefile
calls; ``places`` says where a run writes, ``lines`` what it says, ``custody`` how damage is found,
``command_line`` what is told before the Snakefile is read, ``slurm`` how jobs come into a queue,
``job`` what a script begins with.
"""
