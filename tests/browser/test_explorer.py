"""The explorer as a person uses it: opened from disk in headless Chromium."""

import csv
import json
import math
import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import replace
from html import unescape
from urllib.parse import parse_qs

import numpy as np
import pytest

from chenhorng.claims.words import COLOURS, FAILS, HOLDS
from chenhorng.home import config_directory
from thirdbody.bearings import bearing, hertz_contact
from thirdbody.curves import Condition
from thirdbody.ensembles import RANGE
from thirdbody.files import read_yaml
from thirdbody.inputs import load_parameters
from thirdbody.points import solve
from thirdbody.symbols import html
from thirdbody.variables import CONDITION_AXES

LARGEST = 3e6  # bytes of the page
A4 = 717  # pixels between its margins
FIGURES = [f"fig{number:02d}" for number in range(3, 14)]
VIEWS = {"map": "", "figures": "view=figures"}
NEWTONS, SIZES = (0.04, 80.0), (10e-9, 1000e-9)  # ends of the map
AXES = {axis.name: axis for axis in CONDITION_AXES}
FIGURE_11 = Condition(0.0, 300e-9, 300e-9, 1e11)


def tooltip(explorer):
    return explorer.run(
        "const t = document.getElementById('tooltip'); return t.hidden ? '' : t.innerText"
    ).replace("\u00a0", " ")


def colour_of(explorer, variable):
    """A colour of the style as it is shown, such as #ffffff."""
    return explorer.run(
        """const probe = document.body.appendChild(document.createElement('i'));
        probe.style.color = `var(${arguments[0]})`;
        return d3.rgb(getComputedStyle(probe).color).formatHex();""",
        variable,
    )


def downloaded(explorer, button):
    """Text of the file that a button downloads."""
    explorer.run(
        """globalThis.saved = null;
        URL.createObjectURL = (blob) => { blob.text().then((text) => { saved = text; }); return '#'; };
        HTMLAnchorElement.prototype.click = () => {};"""
    )
    explorer.one(button).click()
    explorer.wait("return globalThis.saved !== null")
    return explorer.run("return saved")


@pytest.mark.parametrize("view", VIEWS)
def test_it_opens_without_an_error_or_the_network_and_is_saved_as_a_drawing(explorer, page, view):
    explorer.open(VIEWS[view])
    assert explorer.all("#charts svg")
    assert explorer.console() == []
    asked = {url.split("#")[0] for url in explorer.requests()}
    assert all(url in (page.as_uri(), "about:blank") or url.startswith("data:") for url in asked)
    root = ElementTree.fromstring(downloaded(explorer, "#save-svg"))
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    styles = [path.get("style") or "" for path in root.iter()]
    assert any("stroke" in style for style in styles)
    assert "var(--" not in "".join(styles)
    assert page.stat().st_size < LARGEST


@pytest.mark.parametrize("figure", FIGURES)
def test_every_figure_has_its_curves_marks_key_and_caption(explorer, figure, page):
    explorer.open(f"figure={figure}")
    assert explorer.console() == []
    drawn = page.parents[1] / "figures" / f"{figure}.csv"
    with open(drawn, encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    record = json.loads(drawn.with_suffix(".json").read_text(encoding="utf-8"))
    panels = sorted({row["panel"] for row in rows})
    assert [each.text for each in explorer.all("#charts figcaption b")] == panels
    for place, panel in enumerate(panels):
        of_panel = [row for row in rows if row["panel"] == panel]
        over_load = of_panel[0]["x_name"] != "diameter_ratio"
        curves = {row["curve"] for row in of_panel if row["curve"].startswith("nu =")}
        marks = record["panels"][place]["printed"]
        printed = [each for each in marks if each["is_point_drawn"] or each["is_tolerance_drawn"]]
        printed += record["panels"][place]["limits"]
        shown = explorer.all("#charts figure")[place]
        for kind, key in {".thin": "hairlines", ".range": "ranged"}.items():
            found = shown.find_elements("css selector", kind)
            assert len(found) == len(record["panels"][place][key]), kind
        numbers = [*record["panels"][place]["limits"], *record["panels"][place]["levels"]]
        strips = {str(each["ends"]) for each in numbers if each["is_tolerance_drawn"]}
        assert len(shown.find_elements("css selector", ".strip")) == len(strips)
        assert not over_load or len(shown.find_elements("css selector", ".line")) == len(curves)
        assert len(shown.find_elements("css selector", "g:has(> title), .limit")) == len(printed)
        turning = [row for row in of_panel if row["curve"] == "turning points"]
        assert len(shown.find_elements("css selector", ".star")) == len(turning)
        slight = [row for row in of_panel if row["curve"] == "slight peaks"]
        assert len(shown.find_elements("css selector", ".slight")) == len(slight)
        computed = [row for row in of_panel if row["curve"].startswith("computed")]
        assert len(shown.find_elements("css selector", ".computed")) == len(computed)
        names = [name.text for name in shown.find_elements("css selector", ".end")]
        assert len(names) == len({*names}) and (not names or of_panel[0]["x_name"] == "load")
        title = shown.find_element("css selector", "figcaption").text
        assert ("not in the paper" in title) == (
            of_panel[0]["y_name"] in ("total_contact_area_over_two_body", "turning_point_ratio")
        )
    assert "The paper" in explorer.one("#caption").text
    assert "At the conditions of" not in explorer.one("#caption").text
    entries = [entry.get_attribute("innerHTML") for entry in explorer.all("#key svg")]
    assert len(set(entries)) == len(entries)
    # the clip of each panel cuts off nothing of bars and ranges
    outside = explorer.run(
        """return [...document.querySelectorAll('#charts svg')].flatMap((svg) => {
            const { y, height } = svg.querySelector('clipPath rect').getBBox();
            const boxes = [...svg.querySelectorAll('.tolerance, .range')].map((mark) => mark.getBBox());
            return boxes.filter((box) => box.y < y - 1 || box.y + box.height > y + height + 1); }).length"""
    )
    assert outside == 0 or figure not in ("fig11", "fig12")
    saved = [row["curve"] for row in csv.DictReader(downloaded(explorer, "#save-csv").splitlines())]
    marks = {row["curve"].split("; ")[1] for row in rows if row["curve"].startswith("printed")}
    assert {curve.removeprefix("printed; ") for curve in saved if "printed; " in curve} == marks


@pytest.mark.parametrize("width", [390, 1400])
@pytest.mark.parametrize("view", ["", *(f"figure={figure}" for figure in FIGURES)])
def test_no_text_of_a_chart_is_over_another_an_axis_or_the_edge(explorer, view, width):
    """And curves have names at their ends, or limits have them."""
    explorer.open(view, width=width)
    found = explorer.run(
        """const boxOf = (element, less, more) => {
            const { left, right, top, bottom } = element.getBoundingClientRect();
            return { left: left - more, right: right + more, top: top + less, bottom: bottom - less, text: element.textContent };
        };
        const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
        return [...document.querySelectorAll('#charts figure')].flatMap((figure, place) => {
            const whole = boxOf(figure, 0, 2);
            // letters are less high than their line, and stand apart
            const texts = [...figure.querySelectorAll('svg text')].map((text) => boxOf(text, 2, 2)).filter(({ text }) => text);
            const lines = [...figure.querySelectorAll('.axis path, .axis line:not(.grid)')];
            const axes = lines.map((line) => boxOf(line, 0, 0));
            return texts.flatMap((text, i) => [
                ...[...texts.slice(0, i), ...axes].filter((other) => meet(text, other)),
                ...(text.left < whole.left || text.right > whole.right ? ['the edge'] : []),
            ].map((other) => [place, text.text, other.text ?? other]))
            .concat([...figure.querySelectorAll('.bracket')].filter((name) =>
                name.getBBox().width + 4 > name.previousElementSibling.getBBox().width).map((name) => name.textContent)); });"""
    )
    assert found == []
    for place, panel in enumerate(explorer.all("#charts figure") if view else ()):
        names = panel.find_elements("css selector", "svg .end, svg .bracket")
        assert names, place


def test_a_moved_slider_moves_the_curves_and_leaves_statements_unjudged(explorer):
    from selenium.webdriver.common.keys import Keys

    explorer.open("figure=fig11")
    before, tally = explorer.curve("dry"), explorer.one("#tally").text
    slider = explorer.one(".control:has(#input-spread_ratio) [type=range]")
    slider.send_keys(*[Keys.ARROW_RIGHT] * 40)
    explorer.settle()
    assert explorer.curve("dry") != before
    assert "not judged" in explorer.one("#tally").text and explorer.all("#claims.unjudged")
    assert not explorer.one("#counts").text
    explorer.one("#claims button[data-statement]").click()
    explorer.settle()
    assert "Tolerance: " in explorer.one("#claims .more").text
    assert "Found: " not in explorer.one("#claims .more").text
    explorer.one("#claims button[data-statement]").click()
    explorer.settle()
    explorer.one(".control.changed .back").click()
    explorer.settle()
    assert (explorer.curve("dry"), explorer.one("#tally").text) == (before, tally)
    assert not explorer.all("#claims.unjudged")


@pytest.mark.parametrize(
    ("typed", "shown"),
    [("75,5", "75.5"), ("1×10²", "100"), ("1,000", None)],
)
def test_fields_take_numbers_as_people_write_them(explorer, typed, shown):
    """What has no meaning, or may be one or a thousand, is refused."""
    explorer.open("figure=fig04")
    before = explorer.one("#point").text
    explorer.enter("#condition-viscosity", typed)
    field = explorer.one("#condition-viscosity")
    assert (field.get_attribute("aria-invalid") == "true") == (shown is None)
    note = explorer.one("#condition-viscosity-note").text
    assert "0 to 150 cSt" in note and (f"“{typed}” is not a number" in note) == (shown is None)
    given = parse_qs(explorer.run("return location.hash.slice(1)"))
    assert given.get("viscosity_cSt", ["90"]) == [shown or "90"]
    assert (explorer.one("#point").text == before) == (shown is None)
    refused = explorer.one("#refused").text
    assert refused.startswith("Shown: results of the last valid values. Viscosity") == (
        shown is None
    )
    assert (explorer.one("#point").value_of_css_property("opacity") != "1") == (shown is None)
    explorer.one("#reset").click()
    explorer.settle()
    assert explorer.one("#refused").text == ""


def test_particles_too_soft_are_refused(explorer):
    """In the field, where the reason is told, and in a link."""
    explorer.open("figure=fig04&hardness_surface_1=1.6e10")
    explorer.run("for (const each of document.querySelectorAll('details')) each.open = true")
    explorer.enter("#input-elastic_modulus_particle", "50")
    assert "50 is out of range" in explorer.one("#input-elastic_modulus_particle-note").text
    assert (
        "elastic factor of at most 1" in explorer.one("#input-elastic_modulus_particle-note").text
    )
    assert "elastic_modulus_particle" not in explorer.run("return location.hash")
    explorer.enter("#input-elastic_modulus_particle", "80")
    assert "elastic_modulus_particle" in explorer.run("return location.hash")
    explorer.open("figure=fig04&hardness_surface_1=1.6e10&elastic_modulus_particle=5e10")
    assert explorer.run("return location.hash") == ""
    assert "particles that are too soft" in explorer.one("#damaged").text


def test_what_the_paper_and_what_no_interface_has_is_said(explorer):
    notes = explorer.open("particle_density_per_m2=1e13&ball_radius=1e-5").one("#notes").text
    assert "particle density 10¹³ m⁻²: the paper has 10¹⁰ to 5×10¹² m⁻²" in notes
    assert "of the ball" in notes
    notes = explorer.open("load_N=1e4&roughness_nm=500").one("#notes").text
    assert notes.startswith("normal load 10⁴ N: the paper has 0.04 to 80 N; mean Hertz pressure ")
    assert "above the hardness of the softer surface, 5000 MPa" in notes and "rough" not in notes
    assert "the paper has" not in explorer.open("load_N=80&viscosity_cSt=0").one("#notes").text


def test_another_interpretation_is_another_model(explorer):
    explorer.open("figure=fig04")
    before = explorer.curve("ν = 90 cSt")
    directory = config_directory()
    default = directory.parent / read_yaml(directory / "config.yaml")["calibrated"]
    word = read_yaml(default)["inputs"]["film_load"]
    explorer.choose("#input-film_load", "total" if word == "fluid" else "fluid")
    assert explorer.curve("ν = 90 cSt") != before
    explorer.one("#reset").click()
    explorer.settle()
    assert explorer.one("[name=figure]").get_attribute("value") == "fig11"
    explorer.run("document.querySelector('[name=view][value=figures]').click()")
    explorer.choose("[name=figure]", "fig04")
    assert explorer.curve("ν = 90 cSt") == before


def test_the_answer_has_the_nominal_and_the_hertz_pressure(explorer, defaults):
    text = explorer.open("load_N=20").one("#point").text
    area, pressure = (float(number) for number in hertz_contact(20.0, defaults))
    for number in f"{1e6 * area:.3g}", f"{1e-6 * pressure:.3g}":
        assert f" {number} M" in text or f" {number} mm²" in text, number
    assert f" {1e-6 * 20.0 / defaults.apparent_area:.3g} MPa" in text


def test_hovering_reads_the_library_s_values(explorer, defaults):
    from selenium.webdriver import ActionChains

    explorer.open("figure=fig11")
    place = explorer.run(
        """const line = document.querySelector('.line[data-label="ν = 150 cSt"]');
        const at = line.getPointAtLength(0.95 * line.getTotalLength());
        const box = line.ownerSVGElement.getBoundingClientRect();
        return [at.x - box.width / 2, at.y - box.height / 2]"""
    )
    svg = explorer.one("#charts svg")
    ActionChains(explorer.driver).move_to_element_with_offset(svg, *map(round, place)).perform()
    explorer.wait("return !document.getElementById('tooltip').hidden")
    read = tooltip(explorer)
    assert "ν = 150 cSt" in read
    load, ratio = (number(read, symbol) for symbol in ("Ft* = ", "Asa,t* = "))
    again = solve(load=load, **FIGURE_11._replace(viscosity=150e-6)._asdict(), parameters=defaults)
    assert float(again.particle_contact_area_ratio) == pytest.approx(ratio, rel=5e-3, abs=1e-4)


def number(text, symbol):
    """The number behind a symbol in a text for readers."""
    found = re.search(re.escape(symbol) + r"([\d.]+)(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?", text)
    power = (found[2] or "⁰").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(f"{found[1]}e{power}")


def test_everything_can_be_reached_and_read_with_the_keyboard(explorer):
    from selenium.webdriver.common.keys import Keys

    explorer.open("figure=fig11")
    for _ in range(400):
        explorer.press(Keys.TAB)
        focus = explorer.run("return document.activeElement.getAttribute('aria-roledescription')")
        if focus:
            break
    explorer.press(Keys.HOME, *[Keys.ARROW_RIGHT] * 5)
    first = explorer.run("return document.getElementById('live').textContent")
    explorer.press(Keys.ARROW_DOWN)
    second = explorer.run("return document.getElementById('live').textContent")
    assert "Ft* = " in first and first != second
    assert tooltip(explorer)
    explorer.press(Keys.ESCAPE)
    assert not tooltip(explorer)


def test_arrow_keys_choose_the_view(explorer):
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys

    explorer.open()
    explorer.run("document.querySelector('[name=view]:checked').focus()")
    ActionChains(explorer.driver).send_keys(Keys.ARROW_RIGHT).perform()
    explorer.settle()
    assert explorer.run("return document.activeElement.value") == "figures"
    assert explorer.one("#heading").text.startswith("Figure 11")
    assert explorer.one("[name=figure]").is_displayed()


def test_controls_and_charts_have_names_for_screen_readers(explorer):
    explorer.open("view=figures")
    tree = explorer.driver.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
    roles = {"slider", "textbox", "combobox", "button", "radio", "application", "link"}
    nodes = [node for node in tree if not node["ignored"] and node["role"]["value"] in roles]
    assert len(nodes) > 60
    assert [node["role"]["value"] for node in nodes if not node["name"]["value"]] == []
    described = [each.get_attribute("textContent") for each in explorer.all("#charts desc")]
    assert len(described) == 3 and all("runs from" in each for each in described)
    assert described[1].startswith(
        "Load percentage of solid, Ls, over dimensionless normal load from "
    )
    assert "dry runs from 100 % to 100 %" in described[1]


def test_states_are_shown_by_more_than_colour(explorer):
    explorer.open("figure=fig11")
    assert {each.text for each in explorer.all("#claims .glyph")} >= {"✓", "✗"}
    # Dry curves are dashed.  Every other curve has a dash or a marker of its own, and a shade that
    # differs from the others in grey.
    lines = explorer.run(
        """return [...document.querySelectorAll('#charts figure:first-child .line:not(.dry)')].map((line) => {
            const [r, g, b] = d3.rgb(getComputedStyle(line).stroke).formatRgb().match(/\\d+/g).map(Number);
            return [line.getAttribute('stroke-dasharray'), 0.3 * r + 0.59 * g + 0.11 * b]; })"""
    )
    grey = sorted(lightness for dash, lightness in lines if dash is None)
    assert np.diff(grey).min() > 4.0
    assert len(explorer.all("#charts figure:first-child g > path[transform]")) > 20


def test_a_chosen_statement_stands_out_in_its_figure(explorer):
    explorer.open("figure=fig04&show=all")
    explorer.one("[data-statement=fig11a-turning-point-load-at-120cst]").click()
    explorer.settle()
    assert explorer.one("[name=figure]").get_attribute("value") == "fig11"
    lines = explorer.all("#charts figure .line.chosen")
    assert {each.get_attribute("data-label") for each in lines} == {"ν = 120 cSt"}
    assert explorer.all("#charts figure .line.faded")
    assert explorer.one("[data-statement=fig11a-turning-point-load-at-120cst][aria-pressed=true]")
    assert "1.49×10⁻⁵ is printed" in explorer.one("#claims .more").text


def test_statements_are_those_of_the_paper_at_any_conditions(explorer):
    explorer.open("figure=fig11")
    before = explorer.one("#claims").text
    explorer.enter("#condition-viscosity", "100")
    assert explorer.curve("ν = 100 cSt")
    assert "ν = 100 cSt (yours)" in explorer.one("#key").text
    assert explorer.one("#claims").text == before
    assert explorer.one("#caption").text.startswith("At the conditions of the paper, with the ")


def content_of(explorer):
    return explorer.run("return JSON.parse(document.getElementById('content').textContent)")


def test_verdicts_are_those_of_the_workflow(explorer, page):
    """For the default, and with departures taken back."""
    results = page.parents[1]
    judged = json.loads((results / "claims" / "claims.json").read_text(encoding="utf-8"))
    departures = results / "extracted" / "departures" / "verdicts.json"
    taken_back = json.loads(departures.read_text(encoding="utf-8"))
    explorer.open("show=all")
    counts = Counter(each["verdict"] for each in judged["statements"])
    tally = explorer.one("#tally").text
    assert tally.startswith(f"Of {counts.total()} shown: ")
    for verdict, words in {"holds": "hold", "fails": "fail", "not tested": "not tested"}.items():
        assert f"{counts[verdict]} {words}" in tally
    assert f"{judged['held']} of {judged['judged']} distinct" in explorer.one("#counts").text
    for statement in judged["statements"][::60]:
        explorer.one(f"[data-statement={statement['id']}]").click()
        explorer.settle()
        text = explorer.one("#claims .more").get_attribute("textContent")
        others = [each["verdicts"][statement["id"]] for each in taken_back]
        changed = [other != statement["verdict"] for other in others if other in ("holds", "fails")]
        assert bool(re.search(r"(Holds|Fails) if: ", text)) == any(changed)


def test_symbols_are_written_as_the_library_writes_them(explorer):
    explorer.open("show=all")
    shown = explorer.run(
        """return Object.fromEntries([...document.querySelectorAll('[data-statement]')].map((each) =>
            [each.dataset.statement, each.children[1].innerHTML]))"""
    )
    texts = {row["id"]: row["statement"] for row in content_of(explorer)["statements"]}
    checked = {name: text for name, text in texts.items() if not re.search(r"\de[+-]?\d", text)}
    assert sum("_" in text for text in checked.values()) > 10
    for name, text in checked.items():
        written = unescape(html(text)).replace("\N{NO-BREAK SPACE}", " ")
        assert shown[name].replace("&nbsp;", " ").startswith(written + " <span"), text
    label = explorer.one("label[for=input-apparent_area]").get_attribute("innerHTML")
    assert label.partition("]")[0].endswith(f"{html('A_n')} [mm²")
    label = explorer.one("label[for=rig-speed_m_per_s]").get_attribute("innerHTML")
    assert label == f"Entrainment speed {html('u', is_symbol=True)} [m/s]"


def test_no_line_ends_between_a_number_and_its_unit(explorer):
    texts = explorer.open("figure=fig06&show=all").run(
        """return ['notes', 'point', 'caption', 'claims'].map((id) =>
            document.getElementById(id).textContent).join(' ')"""
    )
    apart = r"\d (?:N|nm|mm²|MPa|cSt|m⁻²|%)(?![\w⁻])| = |Figure \d"
    assert re.findall(apart, texts) == []
    assert len(re.findall(apart, texts.replace("\u00a0", " "))) > 50


@pytest.mark.parametrize(("newtons", "count"), [(10.5, 4), (1e4, 0)])
def test_a_load_is_in_the_key_if_a_panel_shows_it(explorer, newtons, count):
    explorer.open(f"figure=fig04&load_N={newtons}")
    assert len(explorer.all("#charts .here")) == count
    assert ("at your conditions" in explorer.one("#key").text) == (count > 0)


@pytest.mark.parametrize("figure", ["fig09", "fig10"])
def test_panels_over_sizes_name_the_modes_and_end_beside_their_marks(explorer, figure):
    explorer.open(f"figure={figure}")
    zones, free = explorer.run(
        """const panel = [...document.querySelectorAll('#charts figure')].at(-1);
        const [mark, frame] = ['.strip', 'clipPath rect'].map((each) => [...panel.querySelectorAll(each)].map((one) => one.getBBox()));
        const right = ({ x, width }) => x + width;
        return [[...panel.querySelectorAll('.zone')].map((zone) => zone.textContent),
            (right(frame[0]) - Math.max(...mark.map(right))) / frame[0].width]"""
    )
    assert zones == ["s-s", "hybrid", "p-s"]
    assert free < 0.1


def test_printed_points_are_those_of_the_figure_in_the_colours_of_their_curves(explorer):
    """And a star within a diamond leaves its edge free."""
    explorer.open("figure=fig11", width=390)
    points, curves, star, diamond = explorer.run(
        """const panel = document.querySelector('#charts figure');
        const strokes = (mark) => [...panel.querySelectorAll(mark)].map((each) => each.getAttribute('stroke'));
        const curve = (label) => strokes(`.line[data-label="${label}"]`);
        const width = (mark) => panel.querySelector(mark).getBBox().width;
        return [strokes('.printed'), ['dry', 'ν = 120 cSt'].flatMap(curve), width('.star'), width('.printed')]"""
    )
    assert points == curves
    assert star < diamond
    assert explorer.one("#charts .printed").value_of_css_property("fill") == "none"


def test_maxima_that_do_not_count_are_hollow_as_in_the_figure(explorer):
    explorer.open("figure=fig10")
    full, hollow = (
        explorer.all(f"#charts figure:first-child .{kind}") for kind in ("star", "slight")
    )
    assert full and hollow
    assert "peak that stands out < 0.02" in explorer.one("#key").text


@pytest.mark.parametrize("figure", FIGURES)
def test_the_answer_is_at_conditions_of_a_curve_and_says_of_which_panels(explorer, figure, page):
    explorer.open(f"figure={figure}")
    shown = [explorer.one(f"#condition-{name}").get_attribute("value") for name in AXES]
    path = page.parents[1] / "figures" / f"{figure}.json"
    panels = json.loads(path.read_text(encoding="utf-8"))["panels"]
    compared = [panel for panel in panels if panel["x"] != "diameter_ratio"]
    point = {
        name: pytest.approx(float(value) * axis.scale)
        for value, (name, axis) in zip(shown, AXES.items(), strict=True)
    }
    has = [point in panel["curves"] for panel in compared]
    own = [panel["letter"] for panel, is_own in zip(compared, has, strict=True) if is_own]
    title = explorer.one("#point caption").text
    assert has[0]
    assert re.findall(r"\b[A-F]\b", title.partition("as in panel")[2]) == ([] if all(has) else own)


def test_ranges_stand_beside_inputs_and_answers(explorer):
    from selenium.webdriver.common.keys import Keys

    explorer.open()
    unknowns = read_yaml(config_directory() / "calibration.yaml")["unknowns"]
    for name, unknown in unknowns.items():
        if name not in ("apparent_area", "summit_radius"):  # shown in other units
            (control,) = explorer.all(f".control:has(#input-{name})")
            low, high = unknown["bounds"]
            assert f"searched {low:g} to {high:g};".replace("-", "−") in control.text
    explorer.one(".control:has(#input-spread_ratio) [type=range]").send_keys(Keys.END)
    explorer.settle()
    field = explorer.one("#input-spread_ratio").get_attribute("value")
    assert float(field) == unknowns["spread_ratio"]["bounds"][1]
    explorer.open("particle_diameter_nm=500")
    ensemble = content_of(explorer)["ensemble"]
    point = dict(load_N=10.0, viscosity=90e-6, particle_diameter=500e-9)
    point |= dict(roughness=300e-9, particle_density=1e11)
    found = ranges_over("particle_contact_area_ratio", point)
    row = re.search(r"(?m)Asa,t\*.* ([\d.]+) to ([\d.]+)$", explorer.one("#point").text)
    assert tuple(map(float, row.groups())) == pytest.approx(tuple(found), abs=rounding(found))
    assert f"{RANGE[1:]}; here of {len(ensemble)} sets" in explorer.one("#definition").text


def rounding(ends):
    """Half of the last digit of a range, the second of its width."""
    return 0.51 * 10.0 ** (math.floor(math.log10(ends[1] - ends[0])) - 1)


def ranges_over(quantity, point, **changed):
    """Both ends of a range over the members, all with what is changed."""
    members = load_parameters().changed(**changed).members
    values = [float(getattr(solve(**point, parameters=each), quantity)) for each in members]
    return np.quantile(values, (0.05, 0.95))


@pytest.mark.parametrize(
    "changed",
    [
        {"spread_ratio": 0.4},
        {"mean_ratio": 0.3, "hardness_surface_1": 5.5e9},
        {"mean_ratio": 0.05, "spread_ratio": 0.38, "participation": 0.6, "summit_radius": 1e-4},
        {"summit_offset_ratio": 0.0, "elastic_depth_ratio": 0.1},  # far from all members
    ],
)
@pytest.mark.filterwarnings("ignore::UserWarning")
def test_calibrated_inputs_follow_what_the_reader_changes_as_in_the_library(explorer, changed):
    explorer.open("&".join(f"{name}={value}" for name, value in changed.items()))
    expected = load_parameters().changed(**changed).members
    found = explorer.run("return thirdbody.members()")
    assert len(found) == len(expected)
    for page, library in zip(found, expected, strict=True):
        numbers = numbers_of(library)
        assert {name: page[name] for name in numbers} == pytest.approx(numbers, rel=1e-9)


def test_what_the_reader_changes_is_changed_in_every_member(explorer):
    explorer.open("figure=fig04&particle_diameter_nm=500&spread_ratio=0.4")
    point = dict(load_N=10.0, viscosity=90e-6, particle_diameter=500e-9)
    point |= dict(roughness=300e-9, particle_density=1e11)
    ends = ranges_over("solid_load_fraction", point, spread_ratio=0.4)
    row = re.search(r"(?m)Ls .* ([\d.]+) to ([\d.]+) %$", explorer.one("#point").text)
    shown = tuple(float(end) / 100.0 for end in row.groups())
    assert shown == pytest.approx(tuple(ends), abs=rounding(ends))
    assert explorer.all("#charts .range")


def test_the_sizes_behind_x_a_are_given(explorer, defaults):
    explorer.open("particle_diameter_nm=500")
    text = explorer.one("#point p").text
    mean, largest, _ = map(float, re.findall(r"([\d.]+) nm", text.partition(":")[2]))
    scatter = 500.0 * defaults.spread_ratio
    assert largest == pytest.approx(defaults.truncation * scatter, rel=5e-3)
    assert mean == pytest.approx(math.sqrt(2.0 / math.pi) * scatter, rel=0.02)


def test_the_size_at_which_a_mode_ends_is_shown(explorer, defaults):
    explorer.open("figure=fig11&viscosity_cSt=0&load_N=2")
    text = explorer.one("#point").text
    size = float(re.search(r"Particle size.*particle-surface from ([\d.]+) nm", text)[1])
    load = 2.0 / defaults.newtons_per_load
    sizes = FIGURE_11._replace(particle_diameter=size * 1e-9 * np.array([0.99, 1.01]))
    found = solve(load=load, **sizes._asdict(), parameters=defaults)
    assert (found.particle_contact_area_ratio > 0.95).tolist() == [False, True]


def test_the_map_has_turning_points_and_other_axes(explorer):
    from selenium.webdriver import ActionChains

    explorer.open()
    assert len(explorer.one("#charts path.turning").get_attribute("d")) > 50
    ActionChains(explorer.driver).move_to_element(explorer.one("#charts svg")).perform()
    assert "Asa,t* = " in tooltip(explorer)
    explorer.choose("[name=map_x]", "viscosity")
    assert "viscosity" in explorer.one("#heading").text
    assert explorer.console() == []


def test_regions_of_the_map_have_the_names_that_the_library_gives_them(explorer, defaults):
    """And the key has nothing else than what the map has."""
    explorer.open()
    names, left, top, width, height = explorer.run(
        """const rect = document.querySelector('#charts rect');
        const names = [...document.querySelectorAll('#charts text.name')].map((name) =>
            [[...name.children].map((line) => line.textContent), name.getAttribute('x'), name.getAttribute('y')]);
        return [names, ...['x', 'y', 'width', 'height'].map((key) => Number(rect.getAttribute(key)))]"""
    )
    assert len(names) == 5
    for lines, x, y in names:
        mode, regime = ", ".join(lines).split(", ")
        newtons = NEWTONS[0] * (NEWTONS[1] / NEWTONS[0]) ** ((float(x) - left) / width)
        size = SIZES[1] + (SIZES[0] - SIZES[1]) * (float(y) - top) / height
        given = FIGURE_11._replace(viscosity=90e-6, particle_diameter=size)._asdict()
        found = solve(load_N=newtons, **given, parameters=defaults).to_dataframe()
        assert found["contact_mode"].item() == mode.replace("-", "_")
        assert found["lubrication_regime"].item() == regime
    key = [each.text for each in explorer.all("#key .entry")]
    assert key == [
        "boundary or mixed lubrication: Ls = 90 %",
        "turning points of the contact area",
        "your conditions",
    ]
    assert explorer.one("[name=show] option").text == "of Figure 11"
    kept = explorer.run(
        """dispatchEvent(new Event('resize')); // the map is solved again
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() =>
            done(document.querySelectorAll('#key .entry').length))));"""
    )
    assert kept == len(key)
    explorer.open("viscosity_cSt=150&map_x=roughness")
    assert "full film" in explorer.one("#charts svg").text + explorer.one("#key").text


def test_where_a_name_has_no_room_the_key_has_the_mode_of_each_colour(explorer):
    explorer.open(width=390)
    assert len(explorer.all("#charts text.name")) < 5
    modes = [each.text for each in explorer.all("#key .entry:has(rect)")]
    assert sorted(modes) == ["hybrid", "particle-surface", "surface-surface"]


def test_borders_of_the_map_are_where_the_library_has_them(explorer, defaults):
    """Every corner of the border between boundary and mixed lubrication has L_s = 0.9."""
    explorer.open()
    path, left, top, width, height = explorer.run(
        """const [border, rect] = ['path.regime', 'rect'].map((each) => document.querySelector(`#charts ${each}`));
        return [border.getAttribute('d'), ...['x', 'y', 'width', 'height'].map((key) => Number(rect.getAttribute(key)))]"""
    )
    corners = np.array(re.findall(r"([\d.]+),([\d.]+)", path), dtype=float)
    across, down = ((corners - [left, top]) / [width, height]).T
    newtons = NEWTONS[0] * (NEWTONS[1] / NEWTONS[0]) ** across
    sizes = SIZES[1] + (SIZES[0] - SIZES[1]) * down
    given = FIGURE_11._replace(viscosity=90e-6, particle_diameter=sizes)._asdict()
    found = solve(load=newtons / defaults.newtons_per_load, **given, parameters=defaults)
    assert len(corners) > 30
    np.testing.assert_allclose(found.solid_load_fraction, 0.9, atol=0.01)


def test_scales_can_be_changed(explorer):
    explorer.open("figure=fig04")
    drawn = {explorer.curve("dry", 1)}
    for value in ("linear", "auto"):
        explorer.choose("[name=y_scale]", value)
        drawn.add(explorer.curve("dry", 1))
    assert len(drawn) == 2  # auto is as it was
    assert explorer.console() == []


def test_a_full_film_has_no_contact_mode(explorer):
    explorer.open("viscosity_cSt=150&particle_diameter_nm=100&load_N=80")
    rows = [each.text for each in explorer.all("#point .frame:first-child th")]
    assert "Lubrication" in rows and "Contact mode" not in rows
    assert "full film from" in explorer.one("#point").text
    explorer.open("viscosity_cSt=150&particle_diameter_nm=100&roughness_nm=100")
    assert re.search(r"(?m)At\* 0$", explorer.one("#point").text)


def test_beyond_the_film_formula_no_lubrication_is_told(explorer):
    explorer.open("figure=fig11&load_N=1e9")
    rows = [each.text for each in explorer.all("#point .frame:first-child th")]
    assert "Status" in rows and "Lubrication" not in rows
    assert "normal load 10⁹ N: the paper has" in explorer.one("#notes").text


def test_lines_bend_without_corners(explorer):
    """Between neighbours of a line the direction changes little, also where a mode begins."""
    explorer.open("figure=fig11&viscosity_cSt=100")
    path = explorer.run("return document.querySelector('#charts .line.mine').getAttribute('d')")
    points = np.array(re.findall(r"([\d.]+),([\d.]+)", path), dtype=float)
    before, after = np.diff(points[:-1], axis=0), np.diff(points[1:], axis=0)
    chord = before + after
    off = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]) / np.hypot(*chord.T)
    assert off.max() < 3.0 and len(points) > 80


def test_sliders_that_change_nothing_are_absent(explorer):
    """And each of the others changes what is drawn."""
    explorer.open("figure=fig10")
    shown = [
        each.get_attribute("id")
        for each in explorer.all("[id^=condition-]:not([id$=note])")
        if each.is_displayed()
    ]
    assert shown == [f"condition-{name}" for name in ("load", "viscosity", "particle_density")]
    for name in shown:
        before = explorer.one("#charts").get_attribute("innerHTML")
        explorer.enter(f"#{name}", "50")
        assert explorer.one("#charts").get_attribute("innerHTML") != before, name


def test_the_link_restores_everything(explorer):
    explorer.open("figure=fig11")
    explorer.choose("[name=figure]", "fig06")
    explorer.enter("#condition-viscosity", "55")
    explorer.enter("#input-spread_ratio", "0.4")
    explorer.choose("#input-film_load", "total")
    explorer.choose("[name=y_scale]", "log")
    fragment = explorer.run("return location.hash.slice(1)")
    expected = "figure=fig06&viscosity_cSt=55&spread_ratio=0.4&film_load=total&y_scale=log"
    assert parse_qs(fragment.partition("&")[2]) == parse_qs(expected)
    look = """return [
        ...[...document.querySelectorAll('#charts .line, #charts .ghost')].map((line) => line.getAttribute('d')),
        ...[...document.querySelectorAll('input, select')].map((field) => field.value),
        document.getElementById('claims').innerText];"""
    before = explorer.run(look)
    assert explorer.open(fragment).run(look) == before


def test_a_link_that_was_cut_or_is_of_other_inputs_says_so(explorer):
    explorer.open("figure=fig04&load_N=20&particle_density_per_m2=1e12&spread_ratio=0.4")
    whole = explorer.run("return location.hash.slice(1)")
    assert whole.startswith("sum=") and explorer.open(whole).one("#damaged").text == ""
    ends = whole[:-1], whole.rpartition("&")[0], whole.replace("=20", "=21"), f"sum=1{whole[4:]}"
    for fragment in ends:
        assert "it was cut or changed" in explorer.open(fragment).one("#damaged").text
        assert explorer.run("return location.hash") == ""


def test_a_page_saved_as_it_stands_opens_again(explorer, tmp_path):
    counts = "return ['#tabs button', '#controls input', '#charts svg'].map((each) => document.querySelectorAll(each).length)"
    before = explorer.open().run(counts)
    saved = tmp_path / "saved.html"
    saved.write_text(explorer.driver.page_source, encoding="utf-8")
    explorer.driver.get(saved.as_uri())
    explorer.settle()
    assert explorer.run(counts) == before


@pytest.mark.parametrize(
    ("fragment", "told"),
    [
        ("figure=fig04&load_N=20&view=axes", "view=axes"),
        ("figure=fig99", "figure=fig99"),
        ("figure=fig04&interpretation=half_free", "interpretation=half_free"),
        ("figure=fig04&viscosity=55", "viscosity=55"),
        ("figure=fig04&viscosity_cSt=", "viscosity_cSt="),
        ("figure=fig04&viscosity_cSt=1,000", "viscosity_cSt=1,000"),
        ("figure=fig04&roughness_nm=-1", "roughness_nm=-1"),
        ("figure=fig04&spread_ratio=abc", "spread_ratio=abc"),
        ("figure=fig04&load_N=2&load_N=3", "load_N=3"),
        ("figure=fig04&viscosity_c", "viscosity_c="),
        ("%%%=1&&=", "%%%=1"),
        ("ball=alumina&particle=silicon nitride", "particle=silicon nitride, which is softer"),
        ("oil_grade=15&temperature_C=150", "oil_grade=15 at temperature_C=150"),
    ],
)
def test_a_damaged_link_says_so_and_shows_the_default(explorer, fragment, told):
    look = "return [...document.querySelectorAll('.line, input, select')].map((each) => each.getAttribute('d') ?? each.value)"
    default = explorer.open().run(look)
    assert explorer.one("#damaged").text == ""
    explorer.driver.get("about:blank")
    explorer.driver.get(f"{explorer.page.as_uri()}#{fragment}")
    explorer.settle()
    damaged = explorer.one("#damaged").text
    assert told in damaged and damaged.endswith("Shown: the default.")
    assert explorer.run(look) == default
    assert explorer.console() == []
    explorer.enter("#condition-load", "20")
    assert explorer.one("#damaged").text == ""


def test_the_link_to_the_figure_keeps_the_state(explorer):
    from selenium.webdriver.common.keys import Keys

    explorer.open("figure=fig04&load_N=20")
    explorer.press(Keys.TAB, Keys.ENTER)
    assert explorer.run("return document.activeElement.id") == "view"
    assert explorer.one("[name=figure]").get_attribute("value") == "fig04"
    assert explorer.one("#condition-load").get_attribute("value") == "20"


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("width", [320, 3840])
def test_nothing_is_cut_off_on_any_screen(explorer, view, width):
    explorer.open(VIEWS[view], width=width, height=800)
    assert explorer.run("return document.documentElement.scrollWidth") <= width
    for svg in explorer.all("#charts svg"):
        assert svg.size["width"] > 250
    if width == 320:
        assert not explorer.one("#controls").is_displayed()
        explorer.one("#inputs summary").click()
        assert explorer.one("#controls").is_displayed()


def contrast(explorer, front, back):
    """Contrast of two colours of the style, as WCAG defines it."""
    lights = []
    for colour in (colour_of(explorer, front), colour_of(explorer, back)):
        parts = np.array([int(colour[place : place + 2], 16) for place in (1, 3, 5)]) / 255.0
        linear = np.where(parts <= 0.03928, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
        lights.append(linear @ [0.2126, 0.7152, 0.0722] + 0.05)
    return max(lights) / min(lights)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_can_be_read_in_the_light_and_in_the_dark(explorer, scheme):
    explorer.open(scheme=scheme)
    for front in ("--ink", "--soft", "--accent", "--error", "--mine"):
        assert contrast(explorer, front, "--paper") >= 4.5, front
    for verdict in (HOLDS, FAILS):  # of a sign beside its words
        assert colour_of(explorer, f"--{verdict}") == COLOURS[verdict].lower()
        assert contrast(explorer, f"--{verdict}", "--paper") >= 3.0, verdict


def test_on_paper_there_are_charts_and_statements_and_no_controls(explorer):
    explorer.open(media="print", scheme="dark", width=700)
    assert colour_of(explorer, "--paper") == "#ffffff"
    assert explorer.one("#charts svg").is_displayed()
    assert explorer.run("return document.querySelector('#claims button').checkVisibility()")
    for control in ("#inputs", "#toolbar", "#reset", "footer"):
        assert not explorer.one(control).is_displayed()


def test_nothing_waits_on_paper(explorer):
    """Printed as soon as the conditions have changed, without a pause."""
    explorer.open("figure=fig11")
    left = explorer.run(
        """location.hash = 'figure=fig11&load_N=20';
        dispatchEvent(new Event('hashchange'));
        const cells = () => [...document.querySelectorAll('#point td')].map((cell) => cell.textContent);
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
            const waiting = cells().includes('…');
            dispatchEvent(new Event('beforeprint'));
            done([waiting, cells().includes('…')]);
        })));"""
    )
    assert left == [True, False]


@pytest.mark.parametrize("view", VIEWS.values())
def test_texts_of_charts_have_seven_points_on_paper(explorer, view):
    """Charts of a wide screen are drawn anew for the page, and again for the screen."""
    widths = "[...document.querySelectorAll('#charts svg')].map((svg) => svg.viewBox.baseVal.width)"
    before = explorer.open(view, width=1920).run(f"return {widths}")
    explorer.run(f"addEventListener('beforeprint', () => {{ globalThis.drawn = {widths}; }})")
    explorer.driver.execute_cdp_cmd("Page.printToPDF", {})
    explorer.wait("return !document.querySelector('[aria-busy=true]')")
    drawn, after, size = explorer.run(
        f"""const texts = [...document.querySelectorAll('#charts text')];
        return [drawn, {widths}, Math.min(...texts.map((text) => parseFloat(getComputedStyle(text).fontSize)))];"""
    )
    shrunk = A4 / (drawn[0] * min(len(drawn), 2))
    assert 0.75 * size * shrunk >= 7.0  # of pixels, in points
    assert after == before


def test_a_move_of_a_slider_redraws_the_curves(explorer):
    explorer.open("figure=fig04")
    before = explorer.curve("ν = 90 cSt")
    move = """const slider = document.querySelector('.control:has(#input-spread_ratio) [type=range]');
        slider.value = arguments[0];
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        requestAnimationFrame(() => requestAnimationFrame(() => arguments[1]()));"""
    explorer.driver.execute_async_script(move, 900)
    explorer.settle()
    assert explorer.curve("ν = 90 cSt") != before


def numbers_of(inputs):
    return {name: each for name, each in inputs.as_dict().items() if not isinstance(each, str)}


def test_materials_and_speed_give_the_inputs_of_the_library(explorer, defaults):
    script = "return [thirdbody.changed(), document.getElementById('rig-speed_m_per_s').value]"
    inputs, speed = explorer.open("ball=silicon nitride&particle=alumina").run(script)
    expected = bearing(defaults, ball="silicon nitride", particle="alumina")
    assert numbers_of(replace(defaults.best, **inputs)) == pytest.approx(
        numbers_of(expected.best), rel=1e-12
    )
    assert float(speed) == pytest.approx(expected.speed, rel=1e-3)
    fragment = "flat=alumina&speed_m_per_s=2&oil_density_kg_per_m3=900&ball_radius=0.01"
    inputs, speed = explorer.open(fragment).run(script)
    oil = dict(speed_m_per_s=2.0, oil_density_kg_per_m3=900.0)
    expected = bearing(defaults, flat="alumina", ball_radius_mm=10.0, **oil)
    assert numbers_of(replace(defaults.best, **inputs)) == pytest.approx(
        numbers_of(expected.best), rel=1e-12
    )
    assert float(speed) == 2.0
    assert "not judged" in explorer.one("#tally").text


def test_particles_softer_than_a_surface_cannot_be_chosen(explorer):
    explorer.open("ball=alumina")
    disabled = [each.text for each in explorer.all("#rig-particle option:disabled")]
    assert disabled == ["silicon nitride"]


@pytest.mark.parametrize(
    ("grade", "temperature", "expected"),
    [(46, 75, 12.5636), (15, -20, 503.294)],  # by ASTM D341
)
def test_an_oil_gives_its_viscosity(explorer, grade, temperature, expected):
    explorer.open(f"figure=fig11&oil_grade={grade}&temperature_C={temperature}")
    shown = float(explorer.one("#condition-viscosity").get_attribute("value"))
    assert shown == pytest.approx(expected, rel=1e-4)
    explorer.enter("#condition-viscosity", "100")
    assert explorer.one("#rig-oil_grade").get_attribute("value") == ""


def test_a_tap_shows_the_value_of_a_point(explorer):
    explorer.open("figure=fig11", width=390)
    x, y = explorer.run(
        """const line = document.querySelector('#charts .line');
        const at = line.getPointAtLength(0.5 * line.getTotalLength());
        const svg = line.ownerSVGElement;
        svg.scrollIntoView();
        const box = svg.getBoundingClientRect();
        return [box.x + at.x, box.y + at.y]"""
    )
    touch = "Input.dispatchTouchEvent"
    points = [{"x": round(x), "y": round(y)}]
    explorer.driver.execute_cdp_cmd(touch, {"type": "touchStart", "touchPoints": points})
    explorer.driver.execute_cdp_cmd(touch, {"type": "touchEnd", "touchPoints": []})
    explorer.wait("return !document.getElementById('tooltip').hidden")
    assert "Ft* = " in tooltip(explorer)


def test_it_needs_no_function_of_recent_browsers_for_its_colours(page):
    assert "light-dark(" not in page.read_text(encoding="utf-8")


def test_there_is_a_way_home(explorer):
    link = explorer.open().one("header a[href='../index.html']")
    assert link.text
