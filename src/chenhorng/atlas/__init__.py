"""The full space of conditions, solved for the default inputs and each member of the ensemble:
``chunk`` solves some surfaces and writes them to a file, ``catalogue`` opens all files."""
