"""The figures, drawn from datasets and tables; nothing is solved or evaluated here.

Each is a function of data that returns a ``Drawing``: the matplotlib figure, and the content of its
panels as data.  Start with ``curves.toml``, the list of the figures of curves.
"""
