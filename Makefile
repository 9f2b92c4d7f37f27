# make reproduce   every dataset, table and figure of the paper, from a fresh clone
# make test        the tests, likewise from a fresh clone
# make docs        the documentation as a site, docs/_build/index.html
# make verify      whether the release is whole, and the products are those that it holds
# make sums     which products are not as they were made
# make test-survival   runs killed, damaged, starved and misconfigured, at length (15 minutes)
# make accuracy    errors and times of the solver, measured on this machine (10 minutes)
# make overhead    the time of a clean run against that of the same jobs if they only import
# make lock        renew the locked dependencies (needs uv)
# make lowest      the unit tests with the oldest dependencies that pyproject.toml allows (needs uv)

PYTHON ?= python3
CORES ?= 2
VENV := .venv
BIN := $(VENV)/bin
LOWEST := $(VENV)/lowest

VERSION := $(shell sed -n 's/^version = "\(.*\)"$$/\1/p' pyproject.toml)

export PYTHONHASHSEED := 0

.PHONY: reproduce test docs test-survival verify sums accuracy overhead lock lowest format clean

reproduce: $(VENV)/workflow.done
	$(BIN)/snakemake -c$(CORES)

test: $(VENV)/test.done
	$(BIN)/snakemake -c$(CORES)
	$(BIN)/python -m pytest --numprocesses=$(CORES) --dist=loadfile

docs: $(VENV)/test.done
	$(BIN)/python -m sphinx -q -W --keep-going docs docs/_build

test-survival: $(VENV)/test.done
	SURVIVAL=long $(BIN)/python -m pytest tests/workflow/survival

$(BIN)/python:
	$(PYTHON) -c "import sys; sys.exit(0 if sys.version_info >= (3, 11) else 'Python 3.11 or newer is needed, this is ' + sys.version.split()[0])"
	$(PYTHON) -m venv $(VENV)

$(VENV)/workflow.done: locks/workflow.txt pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --require-hashes --requirement locks/workflow.txt
	$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --editable .
	touch $@

$(VENV)/test.done: locks/test.txt $(VENV)/workflow.done
	$(BIN)/python -m pip install --quiet --require-hashes --requirement locks/test.txt
	touch $@

verify: $(VENV)/workflow.done
	@$(BIN)/python verification/verify.py results/release/thirdbody-$(VERSION) --results results

sums:
	@find results/.custody -name '[!.]*.sha256' -exec sha256sum --quiet --check {} +

accuracy: $(VENV)/test.done
	$(BIN)/snakemake -c$(CORES) accuracy

overhead: $(VENV)/test.done
	$(BIN)/python benchmarks/measure_overhead.py

lock:
	uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --extra workflow --output-file locks/workflow.txt pyproject.toml
	uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --extra test --constraint locks/workflow.txt --output-file locks/test.txt pyproject.toml

lowest:
	uv venv --quiet --clear --python 3.11 $(LOWEST)
	uv pip install --quiet --python $(LOWEST) --resolution lowest-direct --editable '.[compiled,workflow]'
	uv pip install --quiet --python $(LOWEST) --editable '.[test]'
	$(LOWEST)/bin/python -m pytest tests/unit

format: $(VENV)/test.done
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	$(BIN)/snakefmt workflow/Snakefile workflow/rules

clean:
	rm -rf results logs .snakemake
