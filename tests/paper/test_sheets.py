"""Tables as people read them: a row a curve, few digits, the paper's numbers beside."""

import re

import pytest

from chenhorng.sheets import Sheet, result_name, rounded, sheet_of

NEWTONS = 1e5  # per load
CURVE = {"viscosity_m2_per_s": 9e-5, "particle_diameter_m": 3e-7, "roughness_m": 3e-7}
CURVE |= {"particle_density_per_m2": 1e11}
OTHER = CURVE | {"viscosity_m2_per_s": 0.0}
POINT = {
    "load": 3.1833e-6,
    "load_error": 1e-15,
    "peak_ratio": 0.20049,
    "solid_load_fraction": 0.21094,
    "separation_m": 1.1496e-6,
    "solution_status": "converged",
}


def printed(curve, quantity, value, low, high, **fields):
    empty = dict.fromkeys(("id", "figure", "extreme", "at_quantity"), "")
    given = {"quantity": quantity, "value": value, "low": low, "high": high, "at_level": None}
    return curve | empty | given | fields


def cells(sheet):
    return [[*row.values()] for row in sheet.rows]


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (0.123456, 0.0, "0.123"),
        (0.123456, 0.04, "0.12"),
        (1234.5, 0.0, "1230"),
        (1234.5, 300.0, "1200"),
        (99.99, 0.0, "100"),
        (-0.000123456, 0.0, "-0.000123"),
        (0.0, 0.1, "0"),
        (None, 0.0, ""),
        (float("nan"), float("nan"), "none"),
    ],
)
def test_a_number_has_three_digits_or_those_that_its_error_leaves(value, error, text):
    assert rounded(value, error) == text


def test_a_curve_of_several_figures_is_one_row_in_engineering_units():
    rows = [{"figure": name} | CURVE | POINT for name in ("fig06", "fig11")]
    rows.append({"figure": "fig09"} | OTHER | POINT)
    numbers = [
        printed(OTHER, "turning_point_load", 3.27e-6, 3.11e-6, 3.43e-6),
        printed(CURVE, "turning_point_solid_load_fraction", 0.211, 0.181, 0.241),
    ]
    sheet = sheet_of("tpca_loads", rows, numbers, NEWTONS)
    dry, lubricated = cells(sheet)
    assert lubricated[:5] == ["6, 11", "90", "300", "300", "1e11"]
    assert dry[5:] == ["3.18", "3.27 ± 0.16", "0.318", "0.200", "21.1", "", "1150"]
    assert lubricated[10] == "21.1 ± 3"
    headings = [*sheet.rows[0]]
    assert headings[6] == "F_TPCA* (paper) [10⁻⁶]" and headings[10] == "Lₛ (paper) [%]"


def test_a_windows_ends_stand_in_one_row_beside_the_papers():
    common = {"roughness_m": 3e-7, "error": 1e-9}
    ends = {"low": 0.88072, "high": 1.30188}.items()
    rows = [common | {"end": end, "diameter_over_roughness": value} for end, value in ends]
    surface = dict.fromkeys(CURVE) | {"roughness_m": 3e-7}
    numbers = [printed(surface, "window_low", 0.83, 0.73, 0.93)]
    sheet = sheet_of("tpca_windows", rows, numbers, NEWTONS)
    assert cells(sheet) == [["300", "0.881", "0.83 ± 0.1", "1.30", "264 to 391"]]
    numbers.append(printed(surface, "window_high", 1.2, 1.1, 1.3))
    (row,) = sheet_of("tpca_windows", rows, numbers, NEWTONS).rows
    assert row["high end misses"] == "✗" and "low end misses" not in row


def test_transitions_of_a_curve_stand_in_one_row_as_newtons():
    common = {"figure": "fig05", "load_error": 0.0, "level": 0.05} | CURVE
    common |= {"solution_status": "converged", "quantity": "particle_contact_area_ratio"}
    loads = {"rising": 2e-6, "falling": 9e-5}.items()
    rows = [common | {"direction": direction, "load": load} for direction, load in loads]
    at = {"at_quantity": "solid_load_fraction", "at_level": 0.9}
    numbers = [printed(CURVE, "load", 1e-4, 7e-5, 1.3e-4, **at)]
    sheet = sheet_of("transitions", rows, numbers, NEWTONS)
    (row,) = sheet.rows
    assert row["Lₛ = 90 % (paper) [N]"] == "10 ± 3"
    assert (row["Aₛₐ,ₜ* ↑ 0.05 [N]"], row["Aₛₐ,ₜ* ↓ 0.05 [N]"]) == ("0.200", "9.00")


def test_sensitivities_are_inputs_by_results():
    common = {"output": "turning_point_load", "quantity": "", "level": None} | OTHER
    given = [("mean_ratio", -3.4567, 1e-6), ("truncation", 0.001, 1e-6), ("", None, None)]
    names = ("input", "elasticity", "error")
    rows = [common | dict(zip(names, cell, strict=True)) for cell in given]
    sheet = sheet_of("sensitivity", rows, (), NEWTONS)
    assert [*sheet.rows[0]] == ["input", "turning point: load, dry"]
    assert cells(sheet) == [["mean ratio", "-3.46"], ["truncation", "0"]]


def test_deviations_have_their_median_and_mean_and_say_what_is_missing():
    common = {"id": "a", "statement": "A statement.", "printed": 3.27e-6, "inside": "no"}
    places = "Figure 11A, section 3.3", "Figure 9", "Figure 4C, section 3.3"
    numbers = (3.679e-6, 0.125), (None, -1.0), (3.2046e-6, -0.02)
    rows = [
        common
        | {"place": place, "computed": computed, "deviation": deviation}
        | ({"inside": "yes"} if deviation == -0.02 else {})
        for place, (computed, deviation) in zip(places, numbers, strict=True)
    ]
    sheet = sheet_of("deviations", rows, (), NEWTONS)
    assert cells(sheet) == [
        ["Figure 11A", "A statement.", "3.27e-6", "3.68e-6", "+12.5 %", "✗"],
        ["Figure 9", "A statement.", "3.27e-6", "none", "-100.0 %", "✗"],
        ["Figure 4C", "A statement.", "3.27e-6", "3.20e-6", "-2.0 %", ""],
    ]
    assert "median of the deviations is 12.5 %, the mean 38.2 %" in sheet.note


def test_departures_are_rows_of_counts_and_deviations():
    row = {"departure": "as it is", "inputs": None, "holds": 100.0, "judged": 115.0}
    row |= {"headline": 16.0, "headline_statements": 18.0}
    row |= {"median_deviation": 0.0288, "mean_deviation": 0.0598}
    other = row | {"departure": "all take part", "inputs": "mean_ratio = 1", "holds": 89.0}
    random = row | {"departure": "at random", "holds": 65.0}
    random |= dict.fromkeys(("headline", "median_deviation", "mean_deviation"))
    sheet = sheet_of("departures", [row, other, random], (), NEWTONS)
    assert cells(sheet) == [
        ["as it is", "", "100 of 115", "16 of 18", "2.9 %", "6.0 %"],
        ["all take part", "mean ratio = 1", "89 of 115", "16 of 18", "2.9 %", "6.0 %"],
        ["at random", "", "65 of 115", "", "", ""],
    ]


def test_a_printed_number_that_no_range_misses_or_that_is_a_repeat_is_counted_apart():
    names = "printed", "computed", "low", "high", "inside"
    numbers = [
        (1.0, 0.9999, 1.0, 1.0, "yes"),  # no member misses it
        (1.6, 1.55, 1.55, 1.55, "no"),
        (1.49e-5, 1.69e-5, 1.45e-5, 2.63e-5, "yes"),
        (1.5e-5, 1.69e-5, 1.01e-5, 1.49e-5, "no"),  # the same again
        (0.2, 0.21, 0.1, 0.3, "yes"),
    ]
    common = {"id": "a", "place": "Figure 9", "statement": "A statement."}
    rows = [common | dict(zip(names, row, strict=True)) for row in numbers]
    sheet = sheet_of("coverage", rows, (), NEWTONS)
    assert "Of 5 printed numbers 3 lie within" in sheet.note
    assert "Of the other numbers 1 of 3 lie within." in sheet.note
    assert cells(sheet)[3][2:] == ["1.5e-5", "1.69e-5", "1.01e-5 to 1.49e-5", "no"]


def test_held_out_statements_are_counted_once_and_apart_where_the_paper_says_the_same():
    common = dict.fromkeys(("place", "quote", "statement", "curves", "finding"), "A text.")
    known = {"id": "a", "cluster": "", "figures": "3, 6", "verdict": "holds"}
    new = {"id": "b", "cluster": "twice", "figures": None, "verdict": "holds"}
    repeat = new | {"id": "c", "verdict": "fails"}
    beyond = new | {"id": "d", "cluster": None, "verdict": "not tested"}
    rows = [common | row for row in (known, new, repeat, beyond)]
    sheet = sheet_of("held_out", rows, (), NEWTONS)
    assert [row["verdict"] for row in sheet.rows] == ["holds", "holds", "fails", "not tested"]
    assert [row["also in Figure"] for row in sheet.rows] == ["3, 6", "", "", ""]
    assert "1 of 2 hold, repeats counted once; 0 of 1 where no figure" in sheet.note
    assert "1 cannot be tested" in sheet.note


def test_a_page_is_the_text_and_needs_no_other_file():
    shown = Sheet(title="One", note="Note.", rows=[{"a": "<b> & c"}, {"a": "x_a"}]).html()
    assert shown.count("<table") == 1 and "Note." in shown
    assert "<td>&lt;b&gt; &amp; c</td>" in shown and "<td><i>x</i><sub>a</sub></td>" in shown
    assert "src=" not in shown and re.findall('href="(.*?)"', shown) == [
        "../index.html",
        "../claims/claims.html",
    ]


def test_the_points_of_a_column_of_numbers_stand_below_each_other():
    texts = ["1150", "0.25", "-3.1", "none", "dry", "2 ± 0.3", "1e11", ""]
    sheet = Sheet(title="", note="", rows=[{"n": text, "t": f"{text} nm"} for text in texts])
    assert sheet.decimals == {"n": 2}
    assert [sheet.padding("n", text) for text in texts] == [".00", "", "0", "", "", "0", "", ""]
    assert sheet.html().count('<td class="number"') == len(texts)


def test_a_symbol_is_one_in_its_column_alone():
    sheet = Sheet(title="", note="", rows=[{"symbol": "W", "unit": "N"}])
    assert "<td><i>W</i></td><td>N</td>" in re.sub(r"\n *", "", sheet.html())
    assert r"$W$ & N \\" in sheet.latex("table2")


ROW = {"σ [nm]": "300", "high end": "1.3 ± 0.2", "xₐ [nm]": "264 to 391", "50 % & more_of": ""}
WINDOWS = Sheet(
    title="Windows", note="In F_t* A_n, 1e11 m-2.", rows=[ROW, ROW | {"high end": "none"}]
)


def test_a_table_for_latex_has_numbers_units_caption_and_label():
    text = WINDOWS.latex("windows")
    assert (
        r"\caption{Windows. In $F_{t}^*$ $A_{n}$, $10^{11}$ m$^{-2}$.}\label{tab:windows}" in text
    )
    assert r"{$\sigma$ [nm]} & {high end} & {$x_{a}$ [nm]} & {50 \% \& more\_of}" in text
    assert r"300 & 1.3 \pm 0.2 & 264 to 391 &  \\" in text
    assert r"300 & {none} & 264 to 391 &  \\" in text


def test_latex_reads_a_table_with_a_cell_for_each_column():
    latexwalker = pytest.importorskip("pylatexenc.latexwalker")
    walker = latexwalker.LatexWalker(WINDOWS.latex("windows"), tolerant_parsing=False)
    (table,) = (
        node
        for node in walker.get_latex_nodes()[0]
        if node.isNodeType(latexwalker.LatexEnvironmentNode)
    )
    assert table.nodelist[0].latex_verbatim() == "{SSlS}"
    # macros and signs outside of braces and formulas
    names = [
        getattr(node, "macroname", getattr(node, "specials_chars", "")) for node in table.nodelist
    ]
    body = names[names.index("endfoot") + 1 :]
    assert body.count("\\") == 2 and body.count("&") == 2 * 3


@pytest.mark.parametrize(
    ("output", "quantity", "name"),
    [
        ("window_low", "", "window: low end, σ = 300 nm"),
        ("turning_point_ratio", "", "turning point: Aₛₐ,ₜ*, ν = 90 cSt"),
        ("transition_load", "solid_load_fraction", "load where Lₛ = 90 %, xₐ = 300 nm"),
    ],
)
def test_results_are_named_with_what_tells_them_apart(output, quantity, name):
    assert result_name(CURVE | {"output": output, "quantity": quantity, "level": 0.9}) == name


@pytest.mark.parametrize("table", ["tpca_loads", "transitions"])
def test_there_are_no_columns_of_what_nothing_is_to_be_said(table):
    """Of the paper beside curves of one's own, and of statuses where all have converged."""
    row = CURVE | POINT | {"figure": "mine", "quantity": "", "level": 0.0, "direction": "rising"}
    sheet = sheet_of(table, [row], (), NEWTONS)
    assert next(iter(sheet.rows[0])) == "ν [cSt]"
    assert not any("paper" in name or name == "status" for name in sheet.rows[0])
    assert cells(sheet)[0][:4] == ["90", "300", "300", "1e11"]
    other = row | OTHER | {"solution_status": "area_exceeded"}
    sheet = sheet_of(table, [row, other], (), NEWTONS)
    assert [*sheet.rows[0]][-1] == "status"
    assert {line[0]: line[-1] for line in cells(sheet)} == {"dry": "area exceeded", "90": ""}
