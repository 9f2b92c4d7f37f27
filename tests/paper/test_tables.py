"""Tidy tables: CSV there and back, and their schema."""

import pytest

from chenhorng.tables import TABLES, Column, read_csv, table_schema, write_csv

COLUMNS = (
    Column("figure", "string", "", "figure of the paper"),
    Column("load", "number", "1", "F_t*"),
    Column("separation_m", "number", "m", "mean separation"),
)
ROWS = [
    {"figure": "fig03", "load": 3.563037807e-06, "separation_m": 3.626476607e-07},
    {"figure": 'with "quotes", commas\nand lines', "load": 0.0, "separation_m": None},
]


def test_rows_survive_the_file_and_a_row_without_a_column_is_refused(tmp_path):
    path = tmp_path / "table.csv"
    write_csv(path, ROWS, COLUMNS)
    assert read_csv(path, COLUMNS) == ROWS
    with pytest.raises(KeyError):
        write_csv(path, [{"figure": "fig03"}], COLUMNS)


@pytest.mark.parametrize("name", ["deviations", "departures"])
def test_what_the_model_does_not_give_is_an_empty_cell(tmp_path, name):
    path = tmp_path / f"{name}.csv"
    row = {each.name: 0.25 if each.kind == "number" else "a, b" for each in TABLES[name]}
    missing = {each.name: None for each in TABLES[name][-3:]}
    write_csv(path, [row, row | missing], TABLES[name])
    assert path.read_text().endswith(",,,\n")
    assert read_csv(path, TABLES[name]) == [row, row | missing]


def test_numbers_have_ten_digits_and_lines_end_alike_everywhere(tmp_path):
    path = tmp_path / "table.csv"
    write_csv(path, [ROWS[0] | {"load": 1.0 / 3.0}], COLUMNS)
    assert path.read_bytes() == b"figure,load,separation_m\nfig03,0.3333333333,3.626476607e-07\n"


DAMAGES = {
    "other columns": "figure,load\nfig03,1\n",
    "another order": "load,figure,separation_m\n1,fig03,1\n",
    "nothing": "",
    "a number that is none": "figure,load,separation_m\nfig03,1e,1\n",
    "a row cut short": "figure,load,separation_m\nfig03,1e-6\n",
    "a row too long": "figure,load,separation_m\nfig03,1,2,3\n",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_table_is_named(tmp_path, damage):
    path = tmp_path / "table.csv"
    path.write_text(DAMAGES[damage])
    with pytest.raises(OSError, match=f"^{path} cannot be read"):
        read_csv(path, COLUMNS)


def test_the_schema_describes_each_column_in_its_order():
    schema = table_schema(COLUMNS)
    first, *_, last = schema["fields"]
    assert [field["name"] for field in schema["fields"]] == [column.name for column in COLUMNS]
    assert first == {"name": "figure", "type": "string", "description": "figure of the paper"}
    assert (last["type"], last["description"]) == ("number", "mean separation [m]")
    assert schema["missingValues"] == [""]
