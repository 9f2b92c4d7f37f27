"""What goes to an archive: products, sources, their descriptions, and sums to check them by.

This room knows how a release is named and cited (``citation``), which files of the repository go
with it (``sources``), how its content is described for people (``guide``) and for programs
(``datapackage``, ``crate``, ``codecheck``, ``media``), and how the folder is sealed with sums
(``bag``) and becomes one file (``pack``, ``provenance``).  It may import ``thirdbody.data`` and
what is below.  Begin with ``staging.stage``.
"""
