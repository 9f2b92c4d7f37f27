"""The archive of a release: products, sources, their descriptions, and checksums of all files.

``staging`` fills a folder and packs it.  ``citation`` names the release.  ``files`` lists its
sources and renders templates.  ``descriptions`` and ``crate`` describe the content for people and
programs.
"""
