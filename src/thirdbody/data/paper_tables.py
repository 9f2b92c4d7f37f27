"""Tables 1 and 2 of the paper as printed, with derived entries recomputed."""

from thirdbody.model.parameters import Parameters

# Table 1 prints Poisson's ratio; Young's modulus of the steel is not printed.
POISSON_RATIO = 0.29
STEEL_MODULUS = 205e9  # [Pa]
LOADS = (0.04, 80.0)  # F_t [N], Table 2
LOAD_PARAMETERS = (8.6e-9, 1.8e-5)  # W, Table 2
ROUGHNESSES = (100e-9, 500e-9)  # sigma [m], Table 2
VISCOSITIES = (0.0, 150e-6)  # nu [m2/s], Table 2


def _force_unit(inputs: Parameters) -> float:
    """E_ss R_x^2 [N]."""
    return inputs.elastic_modulus_surfaces * inputs.ball_radius**2


RECOMPUTED = {  # in the unit of the entry, from the inputs and other printed values
    "hertz_modulus": lambda inputs: [STEEL_MODULUS / (2.0 * (1.0 - POISSON_RATIO**2)) / 1e9],
    "normal_load": lambda inputs: [each * _force_unit(inputs) for each in LOAD_PARAMETERS],
    "load_parameter": lambda inputs: [load / _force_unit(inputs) * 1e5 for load in LOADS],
    "speed_parameter": lambda inputs: [
        inputs.speed_per_viscosity * each * 1e10 for each in VISCOSITIES
    ],
    "roughness_parameter": lambda inputs: [each / inputs.ball_radius * 1e5 for each in ROUGHNESSES],
    "hardness_parameter": lambda inputs: [inputs.softer_hardness / inputs.elastic_modulus_surfaces],
}


def paper_table(rows: list[dict], inputs: Parameters) -> list[dict]:
    """Rows of the table ``paper_table``: the ``rows`` of ``config/paper_tables.yaml``, in the same
    order, with derived entries recomputed from ``inputs``."""
    judged = []
    for row in rows:
        recomputed = RECOMPUTED[row["recompute"]](inputs) if "recompute" in row else []
        differing = [
            f"printed {a:g} against {b:.{row['digits'] + 1}g}"
            for a, b in zip(row["printed"], recomputed)
            if float(f"{b:.{row['digits']}g}") != a
        ]
        verdict = "differs" if differing else "agrees"
        judged.append(
            {name: row[name] for name in ("property", "symbol", "unit")}
            | _ends("printed", row["printed"])
            | _ends("recomputed", recomputed)
            | {"verdict": verdict if recomputed else "input"}
            | {"remark": "; ".join(filter(None, [*differing, row.get("remark")]))}
        )
    return judged


def _ends(name: str, values: list) -> dict:
    low, high = (*values, None, None)[:2]
    return {f"{name}_low": low, f"{name}_high": high}
