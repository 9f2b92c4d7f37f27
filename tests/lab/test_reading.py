"""Files of instruments and spreadsheets are read with their units; what may be wrong is refused."""

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb
from thirdbody.lab.reading import read_measured


@pytest.fixture
def read(tmp_path):
    """Function that reads a text as a file."""

    def table_of(text, encoding="utf-8"):
        path = tmp_path / "run.csv"
        path.write_bytes(text.encode(encoding))
        return read_measured(path)

    return table_of


@pytest.mark.parametrize(
    "text",
    [
        'load [N],friction coefficient,time [s],comment\n1,0.11,0,"run 1, oil hot"\n2,0.112,60,ok\n',
        '"load [N]", "friction coefficient"\n1, 0.11\n2, 0.112\n',
        "load [N];friction coefficient;\n1;0,11;\n2;0,112;\n",
        "load (N),friction coefficient (-)\n1,0.11\n2,0.112\n",
        "load / N,friction coefficient / 1\r\n1,0.11\r\n2,0.112\r\n",
        "load [kN],COF [%]\n1e-3,11\n2E-3,11.2\n",
        "# run 3\nTester,UMT\n\nload [N],COF,date; note\n1,0.11,a\n# hot\n2,0.112,b\n",
        "sep=;\nload [N];COF;comment\n1;0,11;hot, 1.5 h\n2;0,112;01.02.2024\n",
        "load [N]\tCOF\n1\t0,11\n2\t0,112\n",
        'load [N],COF\n"1","0,11"\n"2","0,112"\n',
        ",normal force [N],µ\n0,1,0.11\n1,2,0.112\n,,\n",
        "load_N,friction_coefficient\n1,0.11\n2,0.112\n",
    ],
)
def test_files_of_instruments_and_spreadsheets(read, text):
    table, _ = read(text)
    assert table["load_N"].tolist() == [1.0, 2.0]
    assert table["friction_coefficient"].tolist() == [0.11, 0.112]


@pytest.mark.parametrize("encoding", ["cp1252", "utf-8", "utf-8-sig"])
def test_encodings_of_spreadsheets(read, encoding):
    table, _ = read("load [N];film thickness [µm]\r\n5,5;0,9\r\n10;NA\r\n", encoding)
    assert table["load_N"].tolist() == [5.5, 10.0]
    assert table["film_thickness_nm"].tolist() == pytest.approx([900.0, np.nan], nan_ok=True)


@pytest.mark.parametrize(
    ("heading", "column", "number"),
    [
        ("load [1]", "load", 3.0),
        ("viscosity [m2 s-1]", "viscosity_cSt", 3e6),
        ("particle diameter [um]", "particle_diameter_nm", 3000.0),
        ("particle_diameter / µm", "particle_diameter_nm", 3000.0),
        ("roughness [m]", "roughness_nm", 3e9),
        ("particle density [1/mm^2]", "particle_density_per_m2", 3e6),
        ("particle density (mm⁻²)", "particle_density_per_m2", 3e6),
        ("Speed [mm/s]", "speed_m_per_s", 3e-3),
        ("Contact resistance (mΩ)", "contact_resistance_ohm", 3e-3),
        ("separation [um]", "separation_nm", 3000.0),
        ("real contact area [um^2]", "real_contact_area_mm2", 3e-6),
        ("real contact area fraction [%]", "real_contact_area_fraction", 0.03),
        ("fluid load fraction", "fluid_load_fraction", 3.0),
    ],
)
@pytest.mark.filterwarnings("ignore::thirdbody.conditions.OutOfRangeWarning")
def test_units(heading, column, number):
    other = "COF" if column != "friction_coefficient" else "separation [nm]"
    table, _ = read_measured(pd.DataFrame({heading: [3.0], other: [0.1]}))
    assert table[column].tolist() == pytest.approx([number], rel=1e-12)


def test_what_is_left_out_or_missing_is_named(read):
    text = "load [N],COF,time [s],film thickness [1]\n1,,0,1e-4\n2,0.112,1,1e-4\n3,#DIV/0!,2,1e-4\n"
    table, notes = read(text)
    assert table["friction_coefficient"].isna().tolist() == [True, False, True]
    assert "film_thickness_nm" not in table
    assert any("2 of 3" in note for note in notes)
    assert any("time [s], film thickness [1]" in note for note in notes)


def test_the_index_of_a_table_is_kept():
    table = pd.DataFrame({"load [N]": [1, 2], "COF": [0.1, 0.2]}, index=["a", "b"])
    assert read_measured(table)[0].index.tolist() == ["a", "b"]


@pytest.mark.parametrize(
    "text",
    [
        "load [N],wear\n1,1\n",  # nothing measured
        "load [N]\n1\n",
        "load,COF\n1,1\n",  # no unit
        "load [N],separation\n1,1\n",
        "load [N],separation [nm],separation [um]\n1,1,1\n",
        "load [N],separation [nm],separation [nm]\n1,1,1\n",
        "load [N];separation [nm]\n1.000;0,1\n",  # a point between thousands
        'load [N],separation [nm]\n1,"1,200"\n',  # a comma of decimals or of thousands
        # what pandas or pint refuse
        "load [kg],COF\n1,1\n",
        "load [N],separation [s]\n1,1\n",
        "load [N],separation [apples]\n1,1\n",
        "load [N],separation [nm]\n1,1.2.3\n",
        "load [N],separation [nm]\n1,<0.1\n",
        "load [N],COF\n1,10%\n",
        "load [N],COF\n1,0.1 ± 0.2\n",
        "load [N];separation [nm]\n1.000,5;0,1\n",
        "load [N],COF\n1,0,5\n",  # three cells below two headings
        "",
    ],
)
def test_what_is_refused(read, text):
    with pytest.raises((ValueError, pint.DimensionalityError, pint.UndefinedUnitError)):
        read(text)


@pytest.mark.parametrize("unit", ["N**(9**9**9)", "N**9**9**9", "N*10**999999999"])
def test_a_unit_is_not_evaluated(read, unit):
    table, notes = read(f"load [{unit}],COF\n1,0.1\n")
    assert list(table) == ["friction_coefficient"] and unit in notes[0]


@pytest.mark.parametrize(("heading", "number"), [("film thickness [um]", 3e-7), ("COF", 11)])
def test_numbers_that_are_probably_in_another_unit_are_warned_of(heading, number):
    table = pd.DataFrame({heading: [number], "solid load fraction": [0.5]})
    with pytest.warns(tb.OutOfRangeWarning):
        read_measured(table)


def test_columns_of_dates_and_booleans_are_refused():
    for column in (pd.date_range("2026-01-01", periods=2), [True, False]):
        with pytest.raises(ValueError):
            read_measured(pd.DataFrame({"load [N]": column, "COF": [0.1, 0.2]}))
