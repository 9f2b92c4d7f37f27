"""The job and inputs of each product, from Snakemake's own summary."""

import csv
import json
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path
from tempfile import TemporaryDirectory

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged


def summary(config, run):
    """Rows of ``snakemake --detailed-summary`` for the configuration of this run."""
    with TemporaryDirectory() as folder:
        file = Path(folder, "config.json")
        file.write_text(json.dumps(config | ({"run": run} if run else {})), encoding="utf-8")
        command = [sys.executable, "-m", "snakemake", "--detailed-summary", "--nolock"]
        done = subprocess.run(
            [*command, "--configfile", file], capture_output=True, text=True, check=False
        )
    if done.returncode:
        raise ValueError(done.stderr)
    lines = [line for line in done.stdout.splitlines() if "\t" in line]
    return list(csv.DictReader(lines, delimiter="\t"))


def jobs_of(rows, run):
    """One entry per job, after those it depends on; files have the names of a run without a name."""
    jobs = {}
    for row in rows:
        log = row["log-file(s)"]
        files = filter(None, row["input-file(s)"].split(","))
        inputs = [without_run(name, run) for name in files]
        job = jobs.setdefault(log, {"rule": row["rule"], "inputs": inputs, "outputs": []})
        job["outputs"].append(without_run(row["output_file"], run))
    maker = {output: log for log, job in jobs.items() for output in job["outputs"]}
    before = {
        log: [maker[name] for name in job["inputs"] if name in maker] for log, job in jobs.items()
    }
    return [jobs[log] for log in TopologicalSorter(before).static_order()]


def without_run(name, run):
    """The name of a product in a run without a name."""
    return name.replace(f"results/{run}/", "results/", 1) if run else name


with logged(snakemake.log[0]), atomic_write(snakemake.output.jobs) as part:
    run = snakemake.params.run
    found = jobs_of(summary(snakemake.params.config, run), run)
    part.write_text(json.dumps(found, indent=1), encoding="utf-8")
