"""The workflow's own products, as the tests of results read them."""

from pathlib import Path

import pytest

RESULTS = Path(__file__).parents[2] / "results"
FIGURES = [f"fig{number:02d}" for number in range(3, 14)]


@pytest.fixture(scope="session")
def results():
    """The folder of the products."""
    if not (RESULTS / "datasets").is_dir():
        pytest.skip("results/datasets is absent: run `snakemake -c2` first")
    return RESULTS


@pytest.fixture(scope="session")
def datasets(results):
    """The datasets of all figures; one that is missing or damaged is an error."""
    from thirdbody.netcdf import read_plain

    return {
        figure: read_plain(results / "datasets" / f"{figure}.nc").to_xarray() for figure in FIGURES
    }


@pytest.fixture(scope="session", params=FIGURES)
def figure(request):
    """The name of each figure with a dataset in turn."""
    return request.param


@pytest.fixture(scope="session")
def dataset(figure, datasets):
    """The dataset of each figure in turn."""
    return datasets[figure]


@pytest.fixture(scope="session")
def curves(dataset):
    """Conditions (4, curves), and each variable as (loads, curves), of the shown curves."""
    from chenhorng.extraction import curves_of

    conditions, shown = curves_of(dataset)
    return conditions, {name: dataset[name].values[:, shown] for name in dataset.data_vars}
