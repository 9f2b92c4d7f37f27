"""The archive of a release: products, sources, their descriptions, and the sums of all files.

``staging.stage`` fills a folder, and ``bag.pack`` makes it one zip file.  ``citation`` says what a
release is called, ``files`` which sources go with it; ``guide``, ``datapackage`` and ``crate``
describe the content, for people and for programs, by the templates that ``texts`` renders.
"""
