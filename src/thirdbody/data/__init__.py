"""Solved points as archival data: scenes, datasets, tables.

Imports ``thirdbody.curves`` and below.
"""
