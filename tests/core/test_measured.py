"""Measurements: oils and codes of standards, topographies, and data beside the model."""

import shlex
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import thirdbody as tb
from thirdbody.bearings import MATERIALS
from thirdbody.command import main
from thirdbody.lab.estimates import Assumed
from thirdbody.lab.oil import GRADES, viscosity_index_of

DOCS = Path(__file__).parents[2] / "docs"
REST = dict(viscosity_cSt=90, particle_diameter_nm=500, roughness_nm=300)
REST["particle_density_per_m2"] = 1e11
LOADS = [5.0, 10.0, 20.0]


@pytest.mark.parametrize(
    ("at_40", "at_100", "index"),
    [(73.30, 8.86, 92), (22.83, 5.05, 156), (53.47, 7.80, 111)],  # examples of ASTM D2270
)
def test_the_viscosity_index_is_that_of_the_standard(at_40, at_100, index):
    assert viscosity_index_of(at_40, at_100) == pytest.approx(index, abs=0.5)


@pytest.mark.parametrize("grade", [grade for grade in GRADES if grade >= 10])
@pytest.mark.parametrize("index", [60, 95, 160])
def test_an_oil_of_a_grade_has_its_viscosity_and_index(grade, index):
    at_40, at_100 = tb.oil_viscosity([40, 100], grade=grade, viscosity_index=index)
    assert at_40 == pytest.approx(GRADES[grade])
    assert viscosity_index_of(at_40, at_100) == pytest.approx(index)


def test_the_line_goes_through_both_points_and_is_straight_in_its_coordinates():
    kelvin = np.array([313.15, 343.15, 373.15])
    found = tb.oil_viscosity(kelvin - 273.15, points={100: 10.7, 40: 68})
    assert found[[0, 2]] == pytest.approx([68.0, 10.7])
    slopes = np.diff(np.log10(np.log10(found + 0.7))) / np.diff(np.log10(kelvin))
    assert slopes[0] == pytest.approx(slopes[1])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"grade": 47, "viscosity_index": 95}, "grade is 47; allowed: ISO VG 2, 3"),
        ({"viscosity_index": 95}, "allowed: a grade, also with its viscosity_index, or points"),
        ({"grade": 2, "viscosity_index": 95}, "viscosity_index is 95; allowed: "),
        ({"points": {40: 46}}, "points is {40: 46}; allowed: two temperatures"),
        ({"points": {40: 5, 100: 46}}, "points is .*; allowed: two temperatures"),
        ({"points": {40: 10, 100: 2.5}}, "gives 1.19 cSt; allowed: temperatures that give 2"),
    ],
)
def test_what_is_no_oil_is_refused_in_one_line(given, message):
    with pytest.raises(ValueError, match=message):
        tb.oil_viscosity(160, **given)


def test_a_code_counts_the_particles_in_the_film():
    answer = tb.cleanliness("ISO 18/16/13", gap_nm=1000)
    assert answer.value("least_above_4_um") == pytest.approx(1300e6 * 1e-6)  # per m3, m
    assert answer.value("most_above_4_um") == pytest.approx(2500e6 * 1e-6)
    assert answer.value("most_above_14_um") == pytest.approx(80.0)
    half = tb.cleanliness("ISO 4406:2021 */16/13", gap_nm=500, enrichment=2.0)
    assert half.title == "ISO -/16/13 in a film of 500 nm"
    assert half.value("most_above_6_um") == pytest.approx(answer.value("most_above_6_um"))


@pytest.mark.parametrize("code", ["", "18/16", "18/16/13/1", "16/18/13", "99/1/1", "a/b/c"])
def test_what_is_no_code_is_refused_in_one_line(code):
    with pytest.raises(ValueError, match=r"^code is .*; allowed: "):
        tb.cleanliness(code, gap_nm=1000)


def test_less_than_one_particle_in_the_nominal_area_is_said(defaults):
    few = tb.Interface(load_N=10, **REST | {"particle_density_per_m2": 1e6})
    area = defaults.apparent_area
    with pytest.warns(tb.OutOfRangeWarning):
        none = few.changed(particle_density_per_m2=2500.0)
    note = f"{2500.0 * area:.2g} particles in A_n = {area:.3g} m2: most contacts have none"
    assert note in none.state().notes and note in few.compare(none).notes
    assert "particles in A_n" not in str(few.state())


@pytest.fixture(scope="module")
def waves(tmp_path_factory):
    """Waves of known moments: the file, their amplitude [m] and wave number [1/m], and the spacing [m]."""
    pytest.importorskip("SurfaceTopography")
    count, size, amplitude = 192, 50e-6, 1e-7
    number = 2.0 * np.pi * 16 / size
    x, y = np.meshgrid(*2 * [np.arange(count) * size / count], indexing="ij")
    z = amplitude * (np.cos(number * x) + np.cos(number * y))
    path = tmp_path_factory.mktemp("waves") / "waves.xyz"
    np.savetxt(path, 1e6 * np.c_[x.ravel(), y.ravel(), z.ravel() + 0.01 * x.ravel()])
    return path, amplitude, number, size / count


@pytest.mark.parametrize("steps", [1, 4])
def test_the_summits_are_those_of_the_moments_over_the_scale(waves, steps):
    path, amplitude, number, spacing = waves
    scale = steps * spacing
    found = tb.surface(path, unit="um", scale_nm=1e9 * scale)
    apparent = 2.0 * np.sin(0.5 * number * scale) / scale  # of differences over it
    m_0, m_2, m_4 = amplitude**2 * np.array([1.0, apparent**2 / 2, apparent**4 / 2])
    assert found.roughness == pytest.approx(np.sqrt(m_0), rel=0.01)
    assert found.slope == pytest.approx(np.sqrt(m_2), rel=0.02)
    assert found.summit_density == pytest.approx(m_4 / (6 * np.sqrt(3) * np.pi * m_2), rel=0.04)
    assert found.summit_radius == pytest.approx(0.375 * np.sqrt(np.pi / m_4), rel=0.03)
    assert found.scale == pytest.approx(scale)


def test_moments_of_two_surfaces_add_and_become_inputs(waves):
    path, *_ = waves
    one, two = tb.surface(path, unit="um"), tb.surface(path, path, unit="um")
    assert two.roughness == pytest.approx(np.sqrt(2.0) * one.roughness)
    assert two.summit_density == pytest.approx(one.summit_density)
    summits = two.parameters().surface(two.roughness)
    assert summits.summit_radius == pytest.approx(two.summit_radius)
    assert summits.summit_density == pytest.approx(two.summit_density)
    assert two.to_dataframe()["scale"].item() == two.scale


def test_what_is_no_topography_is_refused_in_one_line(waves, tmp_path):
    path, *_ = waves
    text = tmp_path / "text.xyz"
    text.write_text("a b c\n")
    for place, given, message in [
        (path, dict(unit=None), 'it has no length unit; give one, as unit="um"'),
        (path, dict(unit="um", scale_nm=1), "scale_nm is 1; allowed: 260.417 or more"),
        (path, dict(unit="um", scale_nm=1e6), "has no slopes or curvatures over 1e[+]06 nm"),
        (text, dict(unit="um"), r"text\.xyz cannot be used as a topography"),
    ]:
        with pytest.raises(ValueError, match=message):
            tb.surface(place, **given)
    with pytest.raises(FileNotFoundError):
        tb.surface(tmp_path / "absent.xyz")
    with pytest.warns(
        tb.OutOfRangeWarning, match="^roughness is 0.0999.* m; usual: 1e-09 to 0.001 m$"
    ):
        tb.surface(path, unit="m")


WITHOUT_VISCOSITY = {key: value for key, value in REST.items() if key != "viscosity_cSt"}


def data(**more):
    return pd.DataFrame({"load [N]": LOADS, "solid load fraction [%]": [90, 70, 50], **more})


def test_the_model_stands_beside_each_measurement_with_its_range():
    table = tb.compare(data(), **REST).to_dataframe()
    for load, measured, (_, found) in zip(LOADS, (0.9, 0.7, 0.5), table.iterrows(), strict=True):
        rows = tb.Interface(load_N=load, **REST).state().rows
        row = next(row for row in rows if row.name == "solid_load_fraction")
        expected = {"": measured, "_model": row.value, "_low": row.low, "_high": row.high}
        expected["_residual"] = measured - row.value
        for end, value in expected.items():
            assert found[f"solid_load_fraction{end}"] == pytest.approx(value)


def test_variables_have_their_units(defaults):
    given = {"Contact resistance (mohm)": [5, 4, 3], "film_thickness [um]": [1, "", 0.5]}
    given["real contact area [um^2]"] = [1500, 2900, 4600]
    found = tb.compare(data(**given), **REST, assumed=Assumed(resistivity_ohm_m=1e-7))
    solved = tb.solve(load_N=LOADS, **REST)
    area = solved.total_contact_area * defaults.apparent_area
    for name, expected in (
        ("film_thickness_nm", [1000, np.nan, 500]),
        ("film_thickness_nm_model", 1e9 * solved.film_thickness * defaults.ball_radius),
        ("real_contact_area_mm2_model", 1e6 * area),
        ("contact_resistance_ohm_model", 0.5e-7 * np.sqrt(np.pi / area)),
    ):
        np.testing.assert_allclose(found.table[name], expected, rtol=1e-6, err_msg=name)
    assert any("contact_resistance_ohm is an estimate" in note for note in found.answer.notes)
    assert found.to_dataset().sizes == {"row": 3}


def test_friction_is_what_both_carry():
    found = tb.compare(data(**{"friction coefficient": 0.1}), **REST, assumed=Assumed(0.2, 0.05))
    solids = found.table["solid_load_fraction_model"]
    friction = 0.2 * solids + 0.05 * (1.0 - solids)
    assert found.table["friction_coefficient_model"].tolist() == pytest.approx(friction.tolist())


def test_half_the_speed_is_half_the_viscosity():
    slow = tb.compare(data(**{"speed [mm/s]": 2000}), **REST, speed_m_per_s=4)
    thin = tb.compare(data(), **REST | {"viscosity_cSt": 45})
    name = "solid_load_fraction_model"
    assert slow.table[name].tolist() == pytest.approx(thin.table[name].tolist())


def test_a_curve_is_there_where_one_condition_varies(tmp_path):
    one = tb.compare(data(), **REST)
    assert one.along == "load_N" and len(one.curve) == 80
    two = tb.compare(data(**{"viscosity [cSt]": [0, 50, 90]}), **WITHOUT_VISCOSITY)
    assert len(two.curve) == 0
    none = tb.compare(data(), **REST | {"particle_diameter_nm": 9e5}).answer
    assert not none.found and none.rows[0].value is None
    for found in (one, two):
        figure = found.plot()
        figure.savefig(tmp_path / "a.png")  # in the resolution of its style
        width = int.from_bytes((tmp_path / "a.png").read_bytes()[16:20])
        assert width == round(300 * figure.get_figwidth())


def test_spreadsheets_of_other_countries_are_read(tmp_path):
    path = tmp_path / "a.csv"
    for encoding in ("cp1252", "utf-8-sig", "utf-16"):
        path.write_bytes("load [N];film thickness [µm]\r\n5,5;0,9\r\n10;NA\r\n".encode(encoding))
        table = tb.compare(path, **REST).table
        assert table["load_N"].tolist() == [5.5, 10.0]
        assert table["film_thickness_nm"].tolist() == pytest.approx([900.0, np.nan], nan_ok=True)


def test_numbers_in_another_unit_are_told_in_the_unit_that_is_given():
    table = data(**{"viscosity [mm^2/s]": 0.09})
    with pytest.warns(
        tb.OutOfRangeWarning, match="^viscosity is 0.09 mm .*; usual: 0.3 to 10000 mm"
    ):
        tb.compare(table, **WITHOUT_VISCOSITY)
    table = data(**{"film thickness [um]": 3e-7})
    with pytest.warns(
        tb.OutOfRangeWarning, match="thickness is 3e-07 um; usual: 0.0001 to 1000 um"
    ):
        tb.compare(table, **REST)
    with pytest.warns(tb.OutOfRangeWarning, match="boundary_friction is 12; usual: 0.01 to 1"):
        Assumed(boundary_friction=12)
    with pytest.warns(tb.OutOfRangeWarning, match="gap_nm is 1e-06 nm; usual: 1 to 100000 nm"):
        tb.cleanliness("18/16/13", gap_nm=1e-6)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a.csv is empty; allowed: headings and rows"),
        ("load [N],friction coefficient\n", "measured has no rows"),
        ("load [N]\n1\n", "measured has no column of friction coefficient"),
        ("force [N],COF\n1,1\n", r"load is missing; .*; columns left out: force \[N\]$"),
        ("load,wear\n1,1\n", "unit of 'load' is not known; allowed: as 'load .N.'"),
        ("load [kg],separation [nm]\n1,1\n", r"unit of 'load \[kg\]' is not known"),
        ("load [N],separation [furlongs per]\n1,1\n", "not known; allowed: as 'separation .nm.'"),
        ("load [N],wear\n1,1\n", "measured has no column of friction coefficient"),
        ("load [N],separation [nm]\n1,1.2.3\n", "separation .nm. is '1.2.3' in row 1; allowed"),
        ("load [N],separation [nm]\nten,1\n", r"load \[N\] is 'ten' in row 1; allowed: numbers"),
        ("load [N],separation [nm]\n1,inf\n", "separation .nm. is 'inf' in row 1; allowed: numb"),
        ("load [N];separation [nm]\n1.000,5;0,1\n", r"load \[N\] is '1.000,5' in row 1; allowed"),
        ("load [N],separation [nm]\n1,<0.1\n", "separation .nm. is '<0.1' in row 1; allowed"),
        ("load [N],separation [nm]\n1,10%\n", "separation .nm. is '10%' in row 1; allowed"),
        ("load [N];separation [nm]\n1.000;0,1\n", "with a point; allowed: one decimal sign"),
        ('load [N],separation [nm]\n1,"1,200"\n', "'1,200', with a comma of decimals or of thous"),
        ('load [N],separation [nm]\n1,"1\n2,2\n', "a.csv has quotation marks that do not pair"),
        ("load [N],separation [nm]\n-1,1\n", r"load \[N\] is '-1' in row 1; allowed: positive"),
        ("Fz [N],friction\n1,1\n", r"no column of .*; allowed: one or more beside Fz .N., frict"),
        ("PK\0\0", "a.csv is not a text; allowed: a CSV file"),
        ("load [N],separation [nm]\n1,5,1\n", "a.csv has 3 cells in the row '1,5,1'; allowed: 2"),
        ("load [N],separation [nm]\n,1\n", r"load \[N\] is '' in row 1; allowed: numbers"),
        ("load [N],separation [nm]\n1,\n2,NA\n", "separation .nm. has no numbers; allowed: one"),
        (
            "load [N],separation [nm],separation [nm]\n1,1,1\n",
            "a second one of separation; allowed",
        ),
        ("load [N],roughness [nm],separation [nm]\n1,1,1\n", "roughness_nm is given twice"),
        (
            "load [N],speed [m/s],separation [nm]\n1,1,1\n",
            r"speed_m_per_s is None, .*: the speed of the inputs, 4.07 m/s",
        ),
    ],
)
def test_a_file_that_cannot_be_compared_is_refused_in_one_line(tmp_path, text, message):
    path = tmp_path / "a.csv"
    path.write_text(text)
    with pytest.raises(ValueError, match=message) as refused:
        tb.compare(path, **REST)
    assert "\n" not in str(refused.value)


def test_the_page_shows_what_the_command_prints(tmp_path, monkeypatch, capsys):
    page = (DOCS / "compare.md").read_text(encoding="utf-8")
    monkeypatch.chdir(DOCS / "examples")
    command = page.split("```sh\n")[1].split("```")[0].replace("\\\n", " ")
    printed = page.split("```text\n")[1].split("```")[0]
    figure = tmp_path / "compared.svg"
    given = shlex.split(command.replace("compared.svg", str(figure)))
    assert given[0] == "thirdbody" and main(given[1:]) == 0
    assert capsys.readouterr().out == printed
    assert figure.is_file()
    for block in page.split("```python\n")[1:]:
        exec(block.split("```")[0], {})


def test_the_example_is_what_its_generator_writes(tmp_path):
    source = (DOCS / "examples" / "make_measured.py").read_text(encoding="utf-8")
    exec(compile(source, "make", "exec"), {"__file__": str(tmp_path / "make_measured.py")})
    written = (tmp_path / "measured.csv").read_text(encoding="utf-8")
    assert written == (DOCS / "examples" / "measured.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "text",
    [
        'load [N],friction coefficient,time [s],comment\n1,0.11,0,"run 1, oil hot"\n2,0.112,60,ok\n',
        '"load [N]", "friction coefficient"\n1, 0.11\n2, 0.112\n',
        "load [N];friction coefficient;\n1;0,11;\n2;0,112;\n",
        "load,friction coefficient\nN,-\n1,0.11\n2,0.112\n",
        "load (N),friction coefficient (-)\n1,0.11\n2,0.112\n",
        "load / N,friction coefficient / 1\n1,0.11\n2,0.112\n",
        "load [N],COF\n1,0.11\n2,0.112\n",
        "Tester,UMT\n\nload [N],COF,date; note\n1,0.11,a\n2,0.112,b\n",
        "sep=;\nload [N];COF;comment\n1;0,11;hot, 1.5 h\n2;0,112;01.02.2024\n",
        "load [N]\tCOF\n1\t0,11\n2\t0,112\n",
        'load [N],COF\n"1","0,11"\n"2","0,112"\n',
        "load,COF\n[N],[-]\n1,0.11\n2,0.112\n",
        ",normal force in N,µ\n0,1,0.11\n1,2,0.112\n,,\n,,,\n",
        "load_N,friction_coefficient\n1,0.11\n2,0.112\n",
    ],
)
def test_files_of_instruments_and_spreadsheets_are_read(tmp_path, text):
    path = tmp_path / "run.csv"
    path.write_text(text)
    found = tb.compare(path, **REST)
    assert found.table["load_N"].tolist() == [1.0, 2.0]
    assert found.table["friction_coefficient"].tolist() == [0.11, 0.112]


def test_signs_of_typography_are_read(tmp_path):
    path = tmp_path / "run.csv"
    text = "load [N];contact resistance [\u2126];film thickness [µm]\n1;1,5E\u221205;0,9\n"
    path.write_text(text, encoding="utf-8")
    table = tb.compare(path, **REST).table
    assert table["contact_resistance_ohm"].tolist() == [1.5e-5]
    assert table["film_thickness_nm"].tolist() == [900.0]


def test_what_is_left_out_of_a_file_is_named(tmp_path):
    path = tmp_path / "run.csv"
    path.write_text(
        "run 3\nload [N],friction coefficient,time [s],film thickness [1]\n"
        "1,Bad,0,1e-4\n2,0.112,1,1e-4\n3,-,2,1e-4\n4,0.109,3,1e-4\n5,#DIV/0!,4,1e-4\n"
    )
    found = tb.compare(path, **REST)
    assert found.table["friction_coefficient"].isna().tolist() == [True, False, True, False, True]
    assert found.notes[:3] == (
        "lines above the headings left out: 1",
        "friction coefficient has 3 cells without a number: '#DIV/0!', '-', 'Bad'",
        "columns left out: time [s], film thickness [1]",
    )


def test_a_table_with_a_film_in_two_units_and_a_bad_row_of_a_label():
    table = data(**{"film thickness [1]": 1e-4, "film thickness [nm]": [900, 950, 990]})
    assert tb.compare(table, **REST).table["film_thickness_nm"].tolist() == [900, 950, 990]
    table.index = ["a", "b", "c"]
    table.loc["b", "load [N]"] = 0
    with pytest.raises(ValueError, match=r"load \[N\] is 0.0 in row b"):
        tb.compare(table, **REST)


def test_a_speed_that_no_oil_explains_is_refused_with_the_speed_of_the_inputs():
    runs = pd.DataFrame(
        {"speed [m/s]": [0.1, 0.2], "load [N]": [5, 10], "film thickness [nm]": [90, 140]}
    )
    given = REST
    allowed = r"700 to 1100 kg/m3, as at 4.07 m/s \(with 850 kg/m3\)"
    for speed, density in ((0.2, "17306"), (2, "1730.6"), (5.5, "629.3")):
        message = f"speed_m_per_s is {speed}, at which .* {density} kg/m3; allowed: {allowed}"
        with pytest.raises(ValueError, match=message):
            tb.compare(runs, speed_m_per_s=speed, **given)
    found = tb.compare(runs, speed_m_per_s=0.2, oil_density_kg_per_m3=850, **given)
    inputs = tb.bearing(speed_m_per_s=0.2, oil_density_kg_per_m3=850)
    expected = tb.compare(runs, parameters=inputs, speed_m_per_s=0.2, **given)
    assert found == expected
    pint = pytest.importorskip("pint")
    with_units = dict(
        speed_m_per_s=pint.Quantity(200.0, "mm/s"),
        oil_density_kg_per_m3=pint.Quantity(0.85, "g/cm^3"),
        ball_radius_mm=pint.Quantity(6.35e-3, "m"),
    )
    assert found == tb.compare(runs, **with_units, **given)


def test_the_speed_of_all_measurements_gives_the_inputs():
    oil = dict(speed_m_per_s=2, oil_density_kg_per_m3=870, ball_radius_mm=10)
    found = tb.compare(data(), **oil, **REST)
    given = tb.compare(data(), parameters=tb.bearing(**oil), **REST)
    assert found == given
    note = "with an oil of 850 kg/m3, U/nu is for a speed of 2.05 m/s"  # 2 m/s at 870 kg/m3
    assert note in given.notes
    assert "with an oil of 870 kg/m3, U/nu is for a speed of 2 m/s" in found.notes
    dry = REST | {"viscosity_cSt": 0}
    assert not [each for each in tb.compare(data(), **dry).notes if "speed" in each]
    with pytest.raises(ValueError, match="speed_m_per_s is 2, without a column of speeds; allowed"):
        tb.compare(data(), speed_m_per_s=2, **REST)
    with pytest.raises(TypeError, match="unknown condition 'speed'"):
        tb.compare(data(), speed=2, **REST)
    speeds = data(**{"speed [m/s]": [1, 2, 3]})
    at_4 = tb.compare(speeds, speed_m_per_s=4, ball_radius_mm=10, **REST)
    assert at_4 == tb.compare(
        speeds, speed_m_per_s=4, parameters=tb.bearing(ball_radius_mm=10), **REST
    )


def test_the_oil_is_stated_that_the_inputs_stand_for_at_a_speed():
    speeds = data(**{"speed [m/s]": 4.0})
    for ball in ({}, {"ball_radius_mm": 19}):
        found = tb.compare(speeds, speed_m_per_s=4, **ball, **REST)
        assert "with an oil of 865.3 kg/m3, U/nu is for a speed of 4 m/s" in found.notes


def test_the_film_of_a_column_of_speeds_needs_no_other_speed_with_a_density():
    runs = data(**{"speed [m/s]": [1, 2, 3], "film thickness [nm]": 900})
    oil = dict(oil_density_kg_per_m3=900)
    found = tb.compare(runs, **oil, **REST)
    for speed in (0.2, 4):
        other = tb.compare(runs, speed_m_per_s=speed, **oil, **REST).table
        expected = other["film_thickness_nm_model"].tolist()
        assert found.table["film_thickness_nm_model"].tolist() == pytest.approx(expected)
    assert "with an oil of 900 kg/m3, U/nu is for a speed of 3.85 m/s" in found.notes


def test_a_topography_in_two_units_is_warned_of(waves, tmp_path):
    path, *_ = waves
    x, y, z = np.loadtxt(path, unpack=True)
    mixed = tmp_path / "mixed.xyz"
    np.savetxt(mixed, np.c_[1e-3 * x, 1e-3 * y, z])  # lengths in mm, heights in um
    with pytest.warns(
        tb.OutOfRangeWarning, match="root mean square slope .*height_scale_factor=0.001"
    ):
        tb.surface(mixed, unit="mm")


def test_the_roughness_of_two_surfaces():
    assert tb.equivalent_roughness(Rq=(240, 180)) == 300.0
    expected = 300.0 * np.sqrt(np.pi / 2.0)
    assert tb.equivalent_roughness(Ra=(240, 180)) == pytest.approx(expected)
    for bad in ({}, {"Rq": 3}, {"Rq": (1, 2, 3)}, {"Ra": (1, -2)}, {"Rq": (1, 2), "Ra": (1, 2)}):
        with pytest.raises((TypeError, ValueError)):
            tb.equivalent_roughness(**bad)


def test_the_roughness_of_surfaces_with_units_and_of_tables():
    pint = pytest.importorskip("pint")
    lengths = pint.Quantity(0.24, "um"), pint.Quantity(180.0, "nm")
    assert tb.equivalent_roughness(Rq=lengths).to("nm").magnitude == pytest.approx(300.0)
    table = pd.DataFrame({"ball": [240.0, 30.0], "flat": [180.0, 40.0]}, index=["a", "b"])
    found = tb.equivalent_roughness(Rq=(table["ball"], table["flat"]))
    assert found.to_dict() == {"a": 300.0, "b": 50.0}
    assert tb.equivalent_roughness(Rq=(table["ball"], 0.0)).equals(table["ball"])
    with pytest.raises(ValueError, match="different indexes"):
        tb.equivalent_roughness(Rq=(table["ball"], table["flat"].reset_index(drop=True)))
    with pytest.raises(pint.DimensionalityError):
        tb.equivalent_roughness(Rq=(lengths[0], 180.0))


def test_a_grade_alone_has_the_index_of_mineral_oils():
    alone, given = (tb.oil_viscosity(60, grade="ISO VG 46", **each) for each in INDEXES)
    assert alone == given


def test_temperatures_of_a_table_give_a_column_of_the_table():
    table = pd.DataFrame({"oil [C]": [40.0, 80.0]}, index=["cold", "hot"])
    found = tb.oil_viscosity(table["oil [C]"], grade=46)
    assert found.index.equals(table.index) and found["cold"] == pytest.approx(46.0)
    layer = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
    solved = tb.solve(load_N=10, viscosity_cSt=found, **layer).to_dataframe()
    assert solved.index.equals(table.index)


def test_what_is_no_file_of_a_topography_is_refused_in_one_line():
    pytest.importorskip("SurfaceTopography")
    with pytest.raises(ValueError, match="paths is array.*; allowed: paths of files"):
        tb.surface(np.zeros((3, 3)))
    with pytest.raises(FileNotFoundError, match="none.xyz cannot be read .No such file"):
        tb.surface("none.xyz")


INDEXES = {}, {"viscosity_index": 95}


def test_oils_by_the_name_of_their_grade_and_temperatures_with_units():
    pint = pytest.importorskip("pint")
    expected = tb.oil_viscosity(60, grade=46, viscosity_index=95)
    assert tb.oil_viscosity(60, grade="ISO VG 46", viscosity_index=95) == expected
    warm = pint.Quantity(333.15, "kelvin")
    assert tb.oil_viscosity(warm, grade="ISO-VG-46", viscosity_index=95) == pytest.approx(expected)
    with pytest.raises(pint.DimensionalityError):
        tb.oil_viscosity(pint.Quantity(1.0, "m"), grade=46, viscosity_index=95)


def test_what_is_no_measurement_is_refused_in_one_line():
    with pytest.raises(
        ValueError, match="measured is .*; allowed: a pandas.DataFrame, or the path"
    ):
        tb.compare([1.0, 2.0], **REST)


@pytest.mark.parametrize("name", ["silicon nitride", "steel"])
def test_materials_by_name(name):
    assert tb.bearing(ball=name) == tb.bearing(ball=MATERIALS[name])
    with pytest.raises(ValueError, match="ball is 'wood'; allowed: a Material, steel"):
        tb.bearing(ball="wood")


def test_an_index_of_several_levels_is_kept():
    table = data(run=["a", "a", "b"], step=[1, 2, 1]).set_index(["run", "step"])
    found = tb.compare(table, **REST)
    assert found.to_dataframe().index.equals(table.index)
    rows = found.to_dataset()
    assert rows.sizes == {"row": 3} and rows["run"].values.tolist() == ["a", "a", "b"]
