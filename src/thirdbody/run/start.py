"""What precedes the jobs: whoever asks for products, in a run or a query, learns which are damaged.

A query, such as ``--dry-run``, ``--summary``, ``--dag`` or ``--report``, starts no job.  It changes
nothing and waits for nobody.
"""

from __future__ import annotations

import atexit
import hashlib
import json
import os
import stat
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from thirdbody.run import slurm
from thirdbody.run.bytecode import Bytecode
from thirdbody.run.custody import damaged_products
from thirdbody.run.lock import Hold, require_writable
from thirdbody.run.places import Places

USUAL_LIMIT = (100, 1)  # Snakemake's own: jobs to start, in as many seconds
SETTINGS = "THIRDBODY_SETTINGS"  # variable with a digest of the settings of the run
BOOKS = Path(".snakemake")  # which Snakemake keeps, for queries too


def look_before_planning(workflow, bytecode: Bytecode, places: Places) -> None:
    """Have Snakemake, before it decides which jobs to run, learn which products are damaged.

    Damaged products are named on stderr and are to be made again if anything asks for them.  Where
    jobs are to be started, the process first takes their places for itself and prepares ``bytecode``;
    if it cannot, or may not write where it has to, it ends with one line and exit code 1.

    Parameters
    ----------
    workflow
        The ``snakemake.workflow.Workflow`` of the main process, while its Snakefile is read.
    bytecode
        The bytecode that jobs load.
    places
        Where the files of this run go.

    Notes
    -----
    While a Snakefile is read Snakemake does not yet know what it is asked for, and ``onstart``
    comes after its plan, which would be out of date if another run had been under way.  Between
    the two it always calls ``Workflow._build_dag``, which is replaced here.
    """
    _require_writable(BOOKS)
    plan, held = workflow._build_dag, []
    if hasattr(plan, "looks_first"):  # a workflow that uses this one reads it for each `use rule`
        return

    def look_and_plan() -> None:
        runs = workflow.execution_settings is not None and not workflow.dryrun
        if runs:
            held.append(_take(places))
            bytecode.prepare()
            _schedule_as_jobs_end(workflow.scheduling_settings)
        damaged = damaged_products(places.products)
        for product in damaged:
            print(f"{product} is not as it was made: to be made again", file=sys.stderr)
        workflow.dag.forcefiles.update(damaged)  # outputs to make even if they seem up to date
        if not runs:
            _show_as_missing(damaged, workflow.iocache)
        plan()
        if runs:
            _permit_replacing(damaged, workflow.dag)

    look_and_plan.looks_first = True
    workflow._build_dag = look_and_plan


def require_unchanged(settings: Mapping, is_job: bool) -> None:
    """End a job whose settings are not those of the run that put it into the queue of a cluster.

    A job reads the configuration when it begins, which may be long after the run has.

    Parameters
    ----------
    settings
        All settings, as values that YAML has.
    is_job
        Whether this process is such a job.  If it is not, its jobs are to have its own settings.
    """
    text = json.dumps(settings, sort_keys=True, default=str)
    digest = hashlib.sha256(text.encode()).hexdigest()
    if not is_job:
        os.environ[SETTINGS] = digest
    elif os.environ.get(SETTINGS, digest) != digest:
        sys.exit(
            "the configuration was changed after the run of this job began; start the run again"
        )


def record_in_job(workflow) -> None:
    """Have a job in the queue of a cluster record what it made from what, for later runs.

    Else only the run that submitted it does so, which may be dead by then.

    Parameters
    ----------
    workflow
        The ``snakemake.workflow.Workflow`` of the job, while its Snakefile is read.

    Notes
    -----
    Snakemake lets jobs record for themselves where nobody waits for them (``--immediate-submit``).
    """
    plan = workflow._build_dag

    def plan_and_record() -> None:
        plan()
        finished, settings = workflow.persistence.finished, workflow.remote_execution_settings

        async def record(job) -> None:
            settings.immediate_submit = True
            await finished(job)
            settings.immediate_submit = False

        workflow.persistence.finished = record

    workflow._build_dag = plan_and_record


def _schedule_as_jobs_end(settings) -> None:
    """Have Snakemake choose jobs when others end, unless whoever runs it limits how many start.

    Its usual limit, which no run reaches, has it choose again a second after each choice as well, so
    that it chooses the more often the more jobs have ended, and ends a second late.
    """
    limit = settings.max_jobs_per_timespan
    if limit is not None and (limit.max_jobs, limit.timespan) == USUAL_LIMIT:
        settings.max_jobs_per_timespan = None


def _take(places: Places) -> Hold:
    """The hold of a run on its places, which no job of a run before it writes to any more."""
    try:
        held = Hold(places.lock)
    except OSError as error:
        sys.exit(str(error))
    _require_writable(places.products, places.logs)
    os.environ[slurm.RUN] = held.name
    atexit.register(slurm.mark_of(held.name).unlink, missing_ok=True)
    if held.before:
        slurm.cancel(held.before)
    return held


def _require_writable(*folders: Path) -> None:
    """End with one line if one of the ``folders`` may not be written to."""
    try:
        for folder in folders:
            require_writable(folder)
    except OSError as error:
        sys.exit(str(error))


def _show_as_missing(damaged: Iterable[str], iocache) -> None:
    """Have a query plan as if these were not there: it neither refuses them nor calls them ok."""
    iocache.exists_local.update(dict.fromkeys(damaged, False))
    iocache.size.update(dict.fromkeys(damaged, 0))


def _permit_replacing(damaged: Iterable[str], dag) -> None:
    """Make writable what jobs will replace: Snakemake refuses to run them otherwise."""
    planned = {str(output) for job in dag.needrun_jobs() for output in job.output}
    for product in planned.intersection(damaged):
        if not os.access(product, os.W_OK):
            Path(product).chmod(os.stat(product).st_mode | stat.S_IWUSR)
