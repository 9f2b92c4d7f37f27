"""What every figure is drawn with: panels and their axes, the key, styles of curves, saving.

Nothing here knows which figure it serves.  Begin with ``panel.panel_figure``.
"""
