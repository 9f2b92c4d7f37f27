"""The page on other programs: what it shows for Python, Octave and R runs on the products."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.results
PAGE = (ROOT / "docs" / "data.md").read_text(encoding="utf-8")
PROGRAMS = {  # by the language of the block: how to run a file, and what it prints
    "python": ([sys.executable], ".py", "particle_diameter_m"),
    "matlab": (["octave-cli", "--no-gui", "-q"], ".m", "turning points, loads"),
    "r": (["Rscript"], ".r", "viscosity_m2_per_s"),
}


@pytest.mark.parametrize("language", PROGRAMS)
def test_what_the_page_shows_runs(language, tmp_path):
    command, suffix, printed = PROGRAMS[language]
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed")
    (tmp_path / "results").symlink_to(ROOT / "results")
    source = "\n".join(re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL))
    assert source
    path = tmp_path / f"shown{suffix}"
    path.write_text(source, encoding="utf-8")
    done = subprocess.run([*command, path], cwd=tmp_path, capture_output=True, text=True)
    if "there is no package called" in done.stderr:
        pytest.skip("a package of R is not installed")
    assert done.returncode == 0 and printed in done.stdout, done.stderr
