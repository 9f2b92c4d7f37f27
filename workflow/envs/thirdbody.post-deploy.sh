#!/usr/bin/env bash
# Snakemake runs this in the folder of the run, once the environment beside this file is made.
# THIRDBODY_HOME, which the Snakefile sets, is the repository or the package that is installed.
set -euo pipefail
python -m pip install --quiet --require-hashes --requirement "$THIRDBODY_HOME/locks/test.txt"
if [ -f "$THIRDBODY_HOME/pyproject.toml" ]; then
    python -m pip install --quiet --no-deps --no-build-isolation --editable "$THIRDBODY_HOME"
else
    packages=$(python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
    dirname "$THIRDBODY_HOME" >"$packages/thirdbody.pth"
fi
