"""The comparison of two runs finds what was changed, and nothing else."""

import shutil

import numpy as np
import pytest
import xarray as xr

from benchmarks.compare_runs import main


@pytest.fixture
def runs(tmp_path):
    """Two folders of results with the same content."""
    old, new = tmp_path / "old", tmp_path / "new"
    for name in ("datasets", "claims", "figures"):
        (old / name).mkdir(parents=True)
    values = {"separation": ("load", [1e-7, np.nan]), "solution_status": ("load", np.int8([0, 1]))}
    xr.Dataset(values, {"load": [1e-6, 1e-5]}).to_netcdf(old / "datasets" / "fig03.nc")
    (old / "claims" / "claims.csv").write_text("id,value,verdict\nfirst,0.5,holds\n")
    (old / "figures" / "fig03.csv").write_text("label,x,y\ndry,1.0,2.0\ndry,2.0,3.0\n")
    (old / "figures" / "fig03.svg").write_text("<svg/>")
    shutil.copytree(old, new)
    return old, new


def compared(runs, capsys, *more):
    """Exit code and lines."""
    code = main([str(folder) for folder in runs] + list(more))
    return code, capsys.readouterr().out.splitlines()


def put(path, old, new):
    path.write_text(path.read_text().replace(old, new))


def change_dataset(path, name, value):
    data = xr.load_dataset(path)
    data[name][0] = value
    data.to_netcdf(path)


def test_last_digits_are_reported_and_allowed(runs, capsys):
    assert compared(runs, capsys) == (0, ["0 files differ, 0 of them beyond 1e-08"])
    change_dataset(runs[1] / "datasets" / "fig03.nc", "separation", 1e-7 * (1.0 + 1e-10))
    put(runs[1] / "figures" / "fig03.csv", "3.0", "3.0000000003")
    put(runs[1] / "figures" / "fig03.svg", "<svg/>", "<svg />")
    code, lines = compared(runs, capsys)
    assert code == 0
    assert lines == [
        "datasets/fig03.nc: separation 1.0e-10",
        "figures/fig03.csv: y 1.0e-10",
        "figures/fig03.svg: other bytes",
        "3 files differ, 0 of them beyond 1e-08",
    ]
    assert compared(runs, capsys, "--rtol", "1e-11")[0] == 1


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [("dry,1.0", "wet,1.0", "label"), ("dry,2.0,3.0\n", "", "2 rows became 1")],
)
def test_a_change_of_a_table_a_status_or_a_file_counts(runs, capsys, old, new, says):
    put(runs[1] / "claims" / "claims.csv", "holds", "fails")
    put(runs[1] / "figures" / "fig03.csv", old, new)
    change_dataset(runs[1] / "datasets" / "fig03.nc", "solution_status", 3)
    (runs[1] / "figures" / "fig03.svg").unlink()
    code, lines = compared(runs, capsys)
    assert code == 1
    assert any(line.startswith(f"figures/fig03.csv: {says}") for line in lines)
    assert any(line.startswith("claims/claims.csv: first: holds became fails") for line in lines)
    assert "datasets/fig03.nc: solution_status at 1 points" in lines
    assert "figures/fig03.svg: only in the old run" in lines
