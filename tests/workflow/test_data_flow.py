"""Nothing heavy is imported where it is not used."""

HEAVY = {"scipy", "xarray", "netCDF4", "pandas", "matplotlib"}


def test_importing_the_package_loads_nothing_heavy_and_writes_nothing(finished):
    files = {path: path.stat().st_mtime_ns for path in finished.root.rglob("*")}
    told = finished.python(
        "import sys; sys.dont_write_bytecode = True; before = set(sys.modules)\n"
        "import thirdbody; print(*sorted(set(sys.modules) - before))"
    )
    assert told.stdout.split() == ["thirdbody"]
    assert files == {path: path.stat().st_mtime_ns for path in finished.root.rglob("*")}


def test_interpretation_the_workflow_loads_nothing_heavy(sources, tmp_path):
    """Snakemake's own YAML reader takes numpy where there is one: it gets none here."""
    told = sources.copied_to(tmp_path / "thirdbody").python(
        "import sys; sys.modules['numpy'] = None\n"
        "from snakemake.cli import main\n"
        "try:\n    main(['--dry-run', '--quiet'])\n"
        "except SystemExit as end:\n    print(end.code, *sorted(sys.modules))"
    )
    code, *modules = told.stdout.splitlines()[-1].split()
    assert code == "0", told.stdout + told.stderr
    assert HEAVY.isdisjoint(modules)
