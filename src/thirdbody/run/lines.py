"""What a run says on the terminal: one line a job, which says what is made and how many are to be.

All that Snakemake says is in its log file, which it names at the end.
"""

from __future__ import annotations

import logging

SHOWN = ("job_info", "job_error", "group_error")  # kinds of events
PREPARATION = (  # lines of no kind that nobody needs in a run that goes well
    "Assuming unrestricted shared filesystem",
    "Building DAG of jobs",
    "Conda environments: ignored",
    "Config file ",
    "Select jobs to execute",
    "Using shell",
)


def say_one_line_a_job(workflow) -> None:
    """Have Snakemake say one line a job on the terminal; ``--verbose`` says all.

    Parameters
    ----------
    workflow
        The ``snakemake.workflow.Workflow`` of the main process, while its Snakefile is read.
    """
    settings = workflow.output_settings
    if settings.dryrun or settings.verbose or settings.printshellcmds:
        return
    for handler in logging.getLogger("snakemake.logging").handlers:
        if handler.name == "DefaultStreamHandler" and not isinstance(handler.formatter, Lines):
            lines = Lines(workflow, handler.formatter)
            handler.addFilter(lines)
            handler.setFormatter(lines)


class Lines(logging.Formatter):
    """Filter and formatter of Snakemake's events.

    Parameters
    ----------
    workflow
        The workflow, whose jobs are counted.
    usual : logging.Formatter
        Words all but the lines of jobs.
    """

    def __init__(self, workflow, usual: logging.Formatter) -> None:
        super().__init__()
        self._workflow = workflow
        self._usual = usual
        self._begun = 0

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether ``record`` is said."""
        if record.levelno > logging.INFO:
            return True
        event = getattr(record, "event", None)
        return event in SHOWN if event else not str(record.msg).startswith(PREPARATION)

    def format(self, record: logging.LogRecord) -> str:
        """The line of a job that begins; anything else as usual."""
        if getattr(record, "event", None) != "job_info":
            return self._usual.format(record)
        self._begun += 1
        jobs = len(self._workflow.dag)
        return f"{self._begun:>{len(str(jobs))}} of {jobs}  {record.rule_msg or record.rule_name}"
