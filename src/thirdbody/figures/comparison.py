"""Measurements over one condition, with the model's curve and the range of its ensemble."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib.style
import pandas as pd
from matplotlib.figure import Figure

from thirdbody.figures.drawing import STYLE, ShownFigure
from thirdbody.figures.styles import BLUE


def draw(table: pd.DataFrame, curve: pd.DataFrame, along: str, variables: Sequence[str]) -> Figure:
    """A panel for each variable.

    Parameters
    ----------
    table, curve : pandas.DataFrame
        Of ``thirdbody.measured.comparison.Comparison``; without a curve, the model is a mark beside each
        measurement.
    along : str
        The column along x.
    variables : sequence of str
        The columns that were measured.
    """
    with matplotlib.style.context(STYLE, after_reset=True):
        size = 3.4 * len(variables), 2.8
        figure = ShownFigure(figsize=size, layout="constrained")
        for axes, name in zip(figure.subplots(1, len(variables), squeeze=False)[0], variables):
            _draw_panel(axes, table.sort_values(along), curve, along, name)
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _draw_panel(axes, table, curve, along, name):
    model = curve if len(curve) else table
    look = {"linestyle": "-"} if len(curve) else {"linestyle": "none", "marker": "+"}
    axes.plot(model[along], model[f"{name}_model"], color=BLUE, label="model", **look)
    low, high = f"{name}_low", f"{name}_high"
    label = "90 % of the ensemble"
    if low in model and len(curve):
        look = {"color": BLUE, "alpha": 0.2, "linewidth": 0.0}
        axes.fill_between(model[along], model[low], model[high], label=label, **look)
    elif low in model:
        axes.vlines(model[along], model[low], model[high], color=BLUE, alpha=0.4, label=label)
    axes.plot(table[along], table[name], "o", color="black", label="measured")
    least, most = table[along].min(), table[along].max()
    if least > 0.0 and most > 10.0 * least:
        axes.set_xscale("log")
    axes.set_xlabel(along.replace("_", " "))
    axes.set_ylabel(name.replace("_", " "))
