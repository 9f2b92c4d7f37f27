"""Which job of the workflow makes what from what, as its rules tell."""

from __future__ import annotations

from pathlib import Path

from thirdbody.run.places import Places

FILES = ("inputs", "outputs")  # fields of a job that name products


def jobs_behind(paths, rules, places: Places) -> list[dict]:
    """The jobs that make the files ``paths``, each after those that it depends on.

    ``rules`` are those of the workflow, as Snakemake holds them; a job has the fields of
    ``thirdbody.release.crate.Job``.  Its files are called as in a run without a name, whatever the
    run's ``places`` are.
    """
    jobs: dict[str, dict] = {}

    def follow(path):
        job = _job_of(path, rules)
        if job is not None and job["outputs"][0] not in jobs:
            for name in job["inputs"]:
                follow(name)
            jobs[job["outputs"][0]] = job

    for path in paths:
        follow(path)
    return [
        {**job, **{key: [places.without_run(name) for name in job[key]] for key in FILES}}
        for job in jobs.values()
    ]


def _job_of(path, rules) -> dict | None:
    """The job that makes ``path``; None for a file that no rule makes."""
    maker = next((rule for rule in rules if rule.is_producer(path)), None)
    if maker is None:
        return None
    wildcards = maker.get_wildcards(path)
    inputs = maker.expand_input(wildcards)[0]
    modules = [str(module) for module in inputs.get("modules", [])]
    return {
        "rule": maker.name,
        "wildcards": dict(sorted(wildcards.items())),
        "script": f"workflow/scripts/{Path(maker.script).name}",
        "modules": modules,
        "inputs": [str(name) for name in inputs if name not in modules],
        "outputs": [str(name) for name in maker.expand_output(wildcards)[0]],
        "configured": bool(maker.params),
    }
