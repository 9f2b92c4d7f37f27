"""The figures of the paper, and the other figures of the workflow, drawn with
``thirdbody.plotting``.

Datasets and tables are drawn; nothing is solved here.
"""
