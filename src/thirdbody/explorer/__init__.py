"""The explorer: a web page that shows the figures of the paper and evaluates its equations.

``content`` collects the data of the page from products of the workflow; ``page`` combines it with
the template, style and scripts of the folder ``page/`` and with D3 into one file.  Of the scripts,
``model.js`` has the equations, ``curves.js`` curves over the load, and ``judge.js`` the checks of
the statements; the others display them.  Start with ``page.page_text``.
"""
