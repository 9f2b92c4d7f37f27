"""A damaged dataset stops the rule that reads it, which says how to remake the file."""

import random
import re
import shlex
from pathlib import Path

from thirdbody.netcdf import read_plain

DAMAGE = {
    "fig03": lambda content: content[: len(content) // 2],
    "fig09": lambda content: b"",
    "fig11": lambda content: random.Random(0).randbytes(len(content)),
}


def target(figure):
    return f"results/figures/{figure}.svg"


def test_a_damaged_dataset_is_named_with_the_command_that_remakes_it(workspace):
    for figure, harm in DAMAGE.items():
        dataset = workspace.root / f"results/datasets/{figure}.nc"
        dataset.write_bytes(harm(dataset.read_bytes()))
    before = workspace.stamps()

    run = workspace.snakemake(*map(target, DAMAGE))

    shown = run.stdout + run.stderr
    assert run.returncode != 0
    assert "Traceback" not in shown
    for figure in DAMAGE:
        dataset = f"results/datasets/{figure}.nc"
        log = (workspace.root / f"logs/extract_curves/{figure}.log").read_text(encoding="utf-8")
        assert re.fullmatch(rf"{dataset} .*; remake it: snakemake .*{dataset}\n", log)
        assert log.strip() in shown
    # what is made from a damaged dataset goes, all else stays
    kept = {name for name in before if Path(name).stem not in DAMAGE}
    assert {name: before[name] for name in kept} == {
        name: stamp for name, stamp in workspace.stamps().items() if name in kept
    }
    # the command that the last log names, typed as it stands, heals the dataset
    _, *arguments = shlex.split(log.partition("remake it: ")[2])
    assert workspace.snakemake(*arguments).returncode == 0
    read_plain(workspace.root / dataset).to_xarray()
