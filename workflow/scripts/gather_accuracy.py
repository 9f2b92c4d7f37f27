"""The measured errors and times as one dataset, and what the solver is to achieve beside them."""

from benchmarks.archive import accuracy_dataset
from benchmarks.bars import bar_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, read_csv, write_csv, write_text
from thirdbody.job_log import logged

MEASURED = "errors", "extremes", "oracle"
TIMED = "times", "omissions", "scaling", "surfaces", "starts", "streaming"


def gather(paths, dataset, bars, text):
    """Write both from the files ``paths`` of the tables by name."""
    tables = {name: read_csv(path, TABLES[name]) for name, path in paths.items()}
    rows = bar_rows(tables)
    with whole(dataset, bars, text) as (dataset_part, bars_part, text_part):
        measured = accuracy_dataset(tables["errors"], tables["times"])
        measured.to_netcdf(dataset_part, engine="netcdf4", format="NETCDF4")
        write_csv(bars_part, rows, TABLES["bars"])
        write_text(text_part, rows, TABLES["bars"], "github")
    print(f"{sum(row['verdict'] == 'holds' for row in rows)} of {len(rows)} bars hold")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        gather(
            {name: snakemake.input[name] for name in (*MEASURED, *TIMED)},
            snakemake.output.dataset,
            snakemake.output.bars,
            snakemake.output.text,
        )
