"""A run chooses jobs when others end, unless whoever started it limits how many start."""

import pytest
from snakemake.cli import get_argument_parser
from snakemake.settings.types import MaxJobsPerTimespan, SchedulingSettings

from thirdbody.run.start import _schedule_as_jobs_end

USUAL = get_argument_parser().get_default("max_jobs_per_timespan")


@pytest.mark.parametrize(("limit", "kept"), [(USUAL, False), ("1/1s", True), ("100/1m", True)])
def test_a_limit_that_somebody_gave_stays(limit, kept):
    given = MaxJobsPerTimespan.parse_choice(limit)
    settings = SchedulingSettings(max_jobs_per_timespan=given)
    _schedule_as_jobs_end(settings)
    assert settings.max_jobs_per_timespan == (given if kept else None)


def test_no_limit_stays_none():
    settings = SchedulingSettings()
    _schedule_as_jobs_end(settings)
    assert settings.max_jobs_per_timespan is None
