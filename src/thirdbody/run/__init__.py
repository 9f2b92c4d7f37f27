"""What the workflow relies on while it runs.

Imports the standard library.
"""
