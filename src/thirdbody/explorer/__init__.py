"""The explorer: one page for a browser that shows the paper's figures and evaluates its equations.

This room gathers what the page tells from products of the workflow (``content``) and puts it into one
file together with a template, a style, scripts and a charting library (``page``).  The scripts lie in
the folder ``page/``: ``model.js`` has the equations and alone knows them, ``curves.js`` what follows from
them over the load, ``judge.js`` the checks of the statements; the others show it.  It may import
``thirdbody.data`` and what is below.  Begin with ``page.page_text``.
"""
