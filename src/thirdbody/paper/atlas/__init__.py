"""The full space of conditions, solved for the default inputs and each member of the ensemble:
``surfaces`` solves one surface, ``chunk`` writes some to a file, ``catalogue`` opens all files."""
