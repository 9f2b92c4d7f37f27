"""The figures of curves in the paper, and those of other scenes, with the printed numbers."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from matplotlib.figure import Figure
from matplotlib.text import Annotation

from chenhorng.claims.words import counted, counts_by_part
from chenhorng.figures import printed as printed_marks
from chenhorng.figures.captions import REMARKS, SENTENCES, place_of
from chenhorng.figures.findings import headline
from chenhorng.figures.numbers import draw_numbers, hide_coinciding
from chenhorng.figures.printed import LOCUS
from chenhorng.tables import TABLES, read_csv
from thirdbody.netcdf import PlainDataset, read_plain
from thirdbody.notes import wrapped
from thirdbody.plotting.load_curves import Content, CurveFigure, curve_figure
from thirdbody.plotting.marks import BAND, read_turning_points, turning_point_series
from thirdbody.plotting.panels import Curve, Series
from thirdbody.plotting.scales import axis_label

RATIO, SOLID = Content("particle_contact_area_ratio"), Content("solid_load_fraction")
AREA, FILM = Content("total_contact_area"), Content("film_thickness")
RELATIVE_AREA = Content("total_contact_area_over_two_body", remark=REMARKS["relative"])
OVER_SIZES = "diameter_ratio"  # x of panels of turning points
TURNING_POINTS = Content("turning_point_ratio", x=OVER_SIZES, remark=REMARKS["ours"])
AREA_BESIDE_RATIO = "AADDD", "BBCC"  # its curves lie close together, those of the ratio apart
# The conditions of the curves have the same name in config/scenes.yaml.  Other scenes need no
# entry here.
CURVE_FIGURES: dict[str, CurveFigure] = {
    # dry: from the p-s over the hybrid to the s-s mode
    "fig03": CurveFigure("particle_diameter", (RATIO, AREA, RELATIVE_AREA)),
    # lubricants, with dry and two-body contact
    "fig04": CurveFigure("viscosity", (RATIO, AREA, SOLID, FILM)),
    # the same on two surfaces
    "fig05": CurveFigure("viscosity", (SOLID,), each=("roughness",)),
    # lubricated and dry contact
    "fig06": CurveFigure(
        "particle_diameter",
        (AREA, SOLID, RATIO, RELATIVE_AREA),
        strong=(300e-9, 500e-9, 700e-9, 1000e-9),
        rows=AREA_BESIDE_RATIO,
    ),
    "fig07": CurveFigure(
        "particle_density",
        (AREA, SOLID, RATIO, RELATIVE_AREA),
        strong=(1e10, 1e11, 5e11, 5e12),
        rows=AREA_BESIDE_RATIO,
    ),
    "fig08": CurveFigure("roughness", (AREA, SOLID, RATIO, RELATIVE_AREA), two_body=False),
    # dry: where the turning point occurs
    "fig09": CurveFigure(
        "particle_diameter",
        (RATIO, AREA, RELATIVE_AREA, TURNING_POINTS),
        two_body=False,
        strong=(250e-9, 300e-9, 350e-9, 400e-9, 500e-9),
        rows=("AADD", "BBCCC"),
    ),
    "fig10": CurveFigure(
        "diameter_ratio",
        (RATIO, TURNING_POINTS),
        each=("roughness",),
        strong=(0.8, 1.0, 1.2, 1.3, 1.5),
    ),
    # how lubricants shift it: over the load and over the film
    "fig11": CurveFigure("viscosity", (RATIO, SOLID, replace(RATIO, x="film_thickness"))),
    # on two surfaces
    "fig12": CurveFigure(
        "viscosity",
        (replace(RATIO, surface=0), replace(SOLID, surface=0), replace(RATIO, surface=-1)),
    ),
    # and with other particle densities
    "fig13": CurveFigure("particle_density", (replace(RATIO, least=0.002),), each=("roughness",)),
}
LEAST_SIZE = 7.0  # of what the paper says, below the title [points]
TITLE_LINE = 0.14  # height of a line above the panels [inches]
BOLD, LEAST = 14.4, 18.0  # characters of both in an inch
WITH_LOCUS = ("fig09",)  # a line joins the turning points in panels of areas


def read_inputs(name: str, files: Any) -> dict[str, Any]:
    """What ``plot`` draws in the figure ``name``, from the input ``files`` of its rule."""
    rows = read_csv(files.printed, TABLES["printed"])
    return {
        "data": read_plain(files.dataset),
        "turning_points": read_turning_points(files.turning_points),
        "ensemble_range": read_plain(files.ensemble_range) if files.ensemble_range else None,
        "printed": [row for row in rows if row["figure"] == name],
        "windows": read_csv(files.windows, TABLES["tpca_windows"]) if files.windows else (),
        "verdicts": read_csv(files.verdicts, TABLES["verdicts"]) if files.verdicts else (),
    }


def plot(
    name: str,
    data: PlainDataset,
    turning_points: Sequence[Mapping] = (),
    ensemble_range: PlainDataset | None = None,
    printed: Sequence[Mapping] = (),
    windows: Sequence[Mapping] = (),
    verdicts: Sequence[Mapping] = (),
    width: float | None = None,
    panel: str = "",
) -> Figure:
    """Draw the figure ``name`` of the paper, or that of any other scene, or one ``panel``.

    ``printed``, ``windows`` and ``verdicts`` are rows of the tables ``printed``, those of this
    figure, ``tpca_windows`` and ``verdicts``; the other arguments and errors are those of
    ``CurveFigure.plot``.
    """

    def add_numbers(content: Content, curves: list[Curve], series: list[Series]) -> None:
        x, y = content.x, content.y
        if x == OVER_SIZES:
            series += turning_point_series(x, y, curves)
            series += printed_marks.window_series(windows, curves[0].condition.roughness)
        if name in WITH_LOCUS and content in (AREA, RELATIVE_AREA):
            for stars in turning_point_series(x, y, curves):
                series += [replace(stars, kind=LOCUS, look=printed_marks.LOOKS[LOCUS]), stars]
            series.sort(key=lambda each: each.kind == BAND)
        series += printed_marks.printed_series(x, y, curves, printed)

    figure = (CURVE_FIGURES.get(name) or curve_figure(data)).plot(
        data,
        turning_points,
        ensemble_range,
        add_series=add_numbers,
        draw_marks=draw_numbers,
        mark_looks=printed_marks.ALL_LOOKS,
        width=width,
        only=panel,
    )
    for axes in figure.axes:
        hide_coinciding(axes)
    over_sizes = [a for a in figure.axes if a.get_xlabel() == axis_label(OVER_SIZES)]
    for axes in over_sizes[1:]:
        axes.sharex(over_sizes[0])
    if len(over_sizes) > 1:
        over_sizes[0].autoscale(axis="x")
    finding, paper = headline(name, data, windows, verdicts)
    if paper and not panel:
        inches = figure.get_figwidth()
        first = wrapped(finding or data.attrs["title"], width=round(BOLD * inches))
        texts = paper, *_count(name, verdicts)
        second = "\n".join(wrapped(text, width=round(LEAST * inches)) for text in texts)
        _write_above(figure, first, second)
    return figure


def _write_above(figure: Figure, first: str, second: str) -> None:
    """Write lines in bold and others below them, above the panels, which keep their heights."""
    room = "\n" * (1 + second.count("\n"))
    lines = (first + room).count("\n") + 1
    figure.set_figheight(figure.get_figheight() + lines * TITLE_LINE)
    title = figure.suptitle(first + room, x=0.01, ha="left", size="medium", weight="bold")
    below = Annotation(second, (0.0, 0.0), xycoords=title, va="bottom", size=LEAST_SIZE)
    figure.add_artist(below)


def _count(name: str, verdicts: Sequence[Mapping]) -> list[str]:
    """How many statements about a figure of the paper have each verdict, if they were judged."""
    own = counts_by_part(verdicts).get(place_of(name))
    return [SENTENCES["count"].format(all=own.total(), each=counted(own))] if own else []
