"""Tables 1 and 2 of the paper as printed, with the derived entries recomputed."""

from collections.abc import Mapping, Sequence

from thirdbody.core.parameters import Parameters
from thirdbody.ensembles import GIGA, STEEL


def _force_unit(inputs: Parameters) -> float:
    """E_ss R_x^2 [N]."""
    return inputs.elastic_modulus_surfaces * inputs.ball_radius**2


# Functions of the inputs and of the printed numbers of the table, by symbol.  They return the
# entry in its own unit.
RECOMPUTED = {
    "hertz_modulus": lambda inputs, printed: [
        GIGA * STEEL.modulus_GPa / (2.0 * (1.0 - ratio**2)) / 1e9
        for ratio in printed["v_s1, v_s2, v_a"]
    ],
    "normal_load": lambda inputs, printed: [
        load * 1e-5 * _force_unit(inputs) for load in printed["W"]
    ],
    "load_parameter": lambda inputs, printed: [
        newtons / _force_unit(inputs) * 1e5 for newtons in printed["F_t"]
    ],
    "speed_parameter": lambda inputs, printed: [
        inputs.speed_per_viscosity * viscosity * 1e-6 * 1e10 for viscosity in printed["nu"]
    ],
    "roughness_parameter": lambda inputs, printed: [
        roughness * 1e-9 / inputs.ball_radius * 1e5 for roughness in printed["sigma"]
    ],
    "hardness_parameter": lambda inputs, printed: [
        inputs.softer_hardness / inputs.elastic_modulus_surfaces
    ],
}


def paper_table(rows: Sequence[Mapping], inputs: Parameters) -> list[dict]:
    """Rows of the table ``paper_table``: the ``rows`` of a table in ``config/paper_tables.yaml``,
    in the same order, with the derived entries recomputed from ``inputs``."""
    printed = {row["symbol"]: row["printed"] for row in rows}
    return [_with_recomputed(row, printed, inputs) for row in rows]


def _with_recomputed(row, printed, inputs):
    recomputed = RECOMPUTED[row["recompute"]](inputs, printed) if "recompute" in row else []
    differing = [
        f"printed {a:g} against {b:.{row['digits'] + 1}g}"
        for a, b in zip(row["printed"], recomputed)
        if float(f"{b:.{row['digits']}g}") != a
    ]
    verdict = "differs" if differing else "agrees"
    return (
        {name: row[name] for name in ("property", "symbol", "unit")}
        | _ends("printed", row["printed"])
        | _ends("recomputed", recomputed)
        | {"verdict": verdict if recomputed else "input"}
        | {"remark": "; ".join(filter(None, [*differing, row.get("remark")]))}
    )


def _ends(name: str, values: list) -> dict:
    low, high = (*values, None, None)[:2]
    return {f"{name}_low": low, f"{name}_high": high}
