"""The explorer: one page for a browser that shows the paper's figures and evaluates its equations.

``content`` gathers what the page shows from products of the workflow, ``page`` puts it into one file
with the template, style and scripts of the folder ``page/`` and with D3. Of the scripts, ``model.js``
has the equations, ``curves.js`` what follows from them over the load, and ``judge.js`` the checks of
the statements; the others show it. Begin with ``page.page_text``.
"""
