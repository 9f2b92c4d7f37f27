"""Numbers of Tables 1 and 2 of the paper, from ``config/paper_tables.yaml``, that defaults of questions are."""

from thirdbody.plain_yaml import config_directory, read_yaml

_TABLES = read_yaml(config_directory() / "paper_tables.yaml")
_PRINTED = {row["symbol"]: row["printed"] for rows in _TABLES.values() for row in rows}

LOADS = tuple(_PRINTED["F_t"])  # first and last [N]
(POISSON_RATIO,) = _PRINTED["v_s1, v_s2, v_a"]
STEEL_MODULUS = 205e9  # [Pa], not printed: E_ss of Table 1 follows from it
