#!/usr/bin/env bash
# Snakemake runs this in the repository, once the environment beside this file is made.
set -euo pipefail
python -m pip install --quiet --no-deps --no-build-isolation --editable .
