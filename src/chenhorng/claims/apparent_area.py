"""The apparent area A_n, which the paper does not print, from the digits of its loads.

F_t* = F_t/(A_n E_ss). The lubricated loads of the text lie on an axis that doubles from step to
step, from 80 N/2^11 to 80 N. So each printed F_t* gives A_n E_ss, up to a power of two, and its
digits say how well.
"""

import math
from collections.abc import Mapping
from typing import Any

from chenhorng.claims.paper_tables import load_parameter, rounding
from thirdbody.core.parameters import Parameters

EXCLUDED, POSSIBLE, TAKEN = "excluded", "possible", "taken"


def losses_of_areas(
    interpretations: Mapping[str, Mapping[str, Any]], losses: Mapping[str, float], area: float
) -> dict[float, float]:
    """The left-out loss [1] by A_n [m2], of interpretations that differ in A_n alone.

    ``interpretations`` are those of ``config/calibration.yaml``, ``losses`` have their left-out
    losses by name, and ``area`` is the A_n of those that fix none.
    """
    fixed = {name: dict(entry["fixed"]) for name, entry in interpretations.items()}
    areas = {name: inputs.pop("apparent_area", area) for name, inputs in fixed.items()}
    others = [inputs for name, inputs in fixed.items() if areas[name] != area]
    return {
        areas[name]: losses[name]
        for name, inputs in fixed.items()
        if name in losses and inputs in others
    }


def area_rows(
    digits: Mapping[str, Any],
    least_load_parameter: float,
    inputs: Parameters,
    modulus: float,
    losses: Mapping[float, float],
) -> list[dict[str, Any]]:
    """Rows of the table ``apparent_area``.

    ``digits`` is the content of ``config/printed_digits.yaml``, ``least_load_parameter`` the
    printed W [1] at the low end of Table 2. A_n follows with the printed E_ss of ``inputs``, and
    with ``modulus`` [Pa], that of the materials. ``losses`` come from ``losses_of_areas``; the area
    with the least is taken. For each A_n that agrees with all printed loads there is a row for each
    load, and one for all of them.
    """
    axis = digits["load_axis"]
    steps = [axis["most_N"] / 2.0**k for k in range(axis["halvings"] + 1)]
    moduli = inputs.elastic_modulus_surfaces, modulus
    rows = []
    for newtons in steps:
        of_loads = _stiffnesses(digits["lubricated_loads"], newtons, steps)
        if of_loads is None:
            continue
        common = max(low for _, low, _ in of_loads), min(high for _, _, high in of_loads)
        area = float(f"{math.fsum(common) / 2.0 / modulus:.2g}")
        for load, (step, *ends) in zip(digits["lubricated_loads"], of_loads, strict=True):
            cells = {"place": load["place"], "printed": load["printed"], "normal_load_N": step}
            rows.append(_row(area, ends, moduli) | cells)
        verdict = _verdict(digits["within_axis"], steps, common, area, losses)
        rows.append(_row(area, common, moduli) | {"place": "all"} | verdict)
    of_all = [row for row in rows if row["verdict"] == POSSIBLE]
    if known := [row for row in of_all if row["area_m2"] in losses]:
        min(known, key=lambda row: losses[row["area_m2"]])["verdict"] = TAKEN
    return [*rows, _least_load(least_load_parameter, steps[-1], inputs, modulus)]


def _stiffnesses(loads, newtons, steps):
    """Of each printed load its step [N] and the ends of A_n E_ss [N], if the first one is at
    ``newtons``; None if they do not overlap."""
    low, high = rounding(loads[0]["printed"], loads[0]["digits"])
    first = newtons / high, newtons / low
    rows = []
    for load in loads:
        least, most = rounding(load["printed"], load["digits"])
        fitting = [n for n in steps if n / most <= first[1] and n / least >= first[0]]
        if not fitting:
            return None
        rows.append((fitting[0], fitting[0] / most, fitting[0] / least))
    return rows


def _verdict(within, steps, common, area, losses):
    """Whether an area is excluded by loads that must lie within the axis; its left-out loss."""
    middle = math.fsum(common) / 2.0
    first, last = steps[-1] / middle, steps[0] / middle
    outside = [load for load in within if not first <= load["printed"] <= last]
    axis = f"the axis has {first:.3g} to {last:.3g}"
    if outside:
        texts = (f"{load['printed']:g} of {load['place']}" for load in outside)
        return {"verdict": EXCLUDED, "remark": f"{axis}, without {', '.join(texts)}"}
    if area in losses:
        axis = f"{axis}; the left-out loss of its search is {losses[area]:.1f}"
    return {"verdict": POSSIBLE, "remark": axis}


def _row(area, ends, moduli):
    """The cells of A_n E_ss from ``ends`` [N]."""
    (low, high), (printed, steel) = ends, moduli
    return {
        "area_m2": area,
        "place": "",
        "printed": None,
        "normal_load_N": None,
        "stiffness_low_N": low,
        "stiffness_high_N": high,
        "printed_modulus_low_m2": low / printed,
        "printed_modulus_high_m2": high / printed,
        "material_modulus_low_m2": low / steel,
        "material_modulus_high_m2": high / steel,
        "verdict": "",
        "remark": "",
    }


def _least_load(printed, newtons, inputs, modulus):
    """Whether the axis begins where W of Table 2 does."""
    here, steel = (load_parameter(newtons, inputs, each) for each in (None, modulus))
    texts = f"{newtons:.4g} N is {here:.4e} with E_ss as printed, {steel:.4e} with that of steel"
    other = f"0.04 N would be {load_parameter(0.04, inputs):.4e}"
    empty = dict.fromkeys(_row(0.0, (0.0, 0.0), (1.0, 1.0)))
    cells = {"place": "Table 2, W", "printed": printed, "normal_load_N": newtons}
    return empty | cells | {"verdict": "", "remark": f"{texts}; {other}"}
