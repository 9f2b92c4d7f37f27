# make reproduce   every dataset, table and figure of the paper, from a fresh clone
# make test        the tests, likewise from a fresh clone
# make coverage    how much of the library its own tests run
# make docs        the documentation as a site, docs/_build/html/index.html
# make verify      whether all products are as they were made, and all releases whole
# make test-survival   runs killed, damaged, starved, misconfigured and on a cluster, and the solver against the oracle, at length
# make release     wheel and sdist in dist/, the archive in results/release/
# make placeholders   fails if an address is still to be written before anything is published
# make accuracy    errors and times of the solver, measured on this machine (some minutes)
# make lock        renew the locked dependencies (needs uv)
# make vendor      the charting library of the explorer, fetched again (needs npm)
# make lowest      the unit tests with the oldest dependencies that pyproject.toml allows (needs uv)

PYTHON ?= python3
CORES ?= 2
VENV := .venv
BIN := $(VENV)/bin
# after pip with --no-compile, which would use one core; without tests of packages, and olefile2, which is for Python 2
COMPILE := $(BIN)/python -m compileall -qq -j 0 -x '/tests/|olefile2' $(VENV)/lib
LOWEST := $(VENV)/lowest

# what the executor for SLURM needs beside locks/workflow.txt
SLURM_PLUGIN := snakemake-executor-plugin-slurm snakemake-executor-plugin-slurm-jobstep

# of the default run, which must be there, and of named runs
SUMS = results/SHA256SUMS $(wildcard results/*/SHA256SUMS)
RELEASES = $(wildcard results/release/*/. results/*/release/*/.)

PLACEHOLDERS = grep --line-number https://placeholder.invalid pyproject.toml CITATION.cff

export PYTHONHASHSEED := 0

.PHONY: reproduce test coverage docs test-survival verify release placeholders accuracy lock vendor lowest format clean

D3 := 7.9.0
VENDOR := src/chenhorng/page/vendor

# Snakemake does not quote the interpreter of a script
ifneq ($(words $(CURDIR)),1)
$(error the path $(CURDIR) has a blank; allowed: a folder whose path has none)
endif

reproduce: $(VENV)/workflow.done
	$(BIN)/snakemake -c$(CORES)

# one thread of linear algebra a process, as processes share the cores; one process more than cores, as some tests wait
PYTEST = OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest --numprocesses=$$(($(CORES) + 1)) --dist=loadfile --no-loadscope-reorder

# a failed run of the workflow does not hide what the tests find
test: $(VENV)/test.done $(VENV)/slurm.done
	@failed=0; $(BIN)/snakemake -c$(CORES) || failed=1; $(PYTEST) -rfEs || failed=1; exit $$failed

# of the library by its own tests, without those of many points, which it would slow
coverage: $(VENV)/test.done
	$(PYTEST) tests/core --ignore=tests/core/test_continuity.py --ignore=tests/core/test_properties.py --cov

docs: $(VENV)/test.done
	$(BIN)/python -m sphinx -q -W --keep-going docs docs/_build/html
	@echo docs/_build/html/index.html

test-survival: $(VENV)/test.done $(VENV)/slurm.done
	SURVIVAL=long $(BIN)/python -m pytest tests/workflow/survival tests/workflow/cluster
	THIRDBODY_POINTS=12000 $(BIN)/python -m pytest tests/oracle/test_whole_domain.py

$(BIN)/python:
	$(PYTHON) -c "import sys; sys.exit(0 if sys.version_info >= (3, 11) else 'Python 3.11 or newer is needed, this is ' + sys.version.split()[0])"
	$(PYTHON) -m venv $(VENV)

$(VENV)/workflow.done: locks/workflow.txt pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --no-compile --require-hashes --requirement locks/workflow.txt
	$(COMPILE)
	$(BIN)/python -m pip install --quiet --no-compile --no-deps --no-build-isolation --editable .
	$(BIN)/python -m compileall -qq src benchmarks
	touch $@

$(VENV)/test.done: locks/test.txt $(VENV)/workflow.done
	$(BIN)/python -m pip install --quiet --no-compile --require-hashes --requirement locks/test.txt
	$(COMPILE)
	touch $@

# a folder of its own: beside Snakemake the plugin slows every command where SLURM does not answer
$(VENV)/slurm.done: locks/slurm.txt | $(BIN)/python
	$(BIN)/python -m pip install --quiet --upgrade --target $(VENV)/slurm --no-deps --require-hashes --requirement locks/slurm.txt
	touch $@

verify: $(VENV)/workflow.done
	@for sums in $(SUMS); do (cd $$(dirname $$sums) && sha256sum --quiet --check SHA256SUMS) || exit 1; done
	@for release in $(RELEASES); do $(BIN)/python verification/verify.py $$release --packed || exit 1; done

release: $(VENV)/workflow.done
	$(BIN)/snakemake -c$(CORES) all release
	rm -rf dist
	$(BIN)/python -m hatchling build
	$(MAKE) verify
	@! $(PLACEHOLDERS) || echo 'These addresses are to be written before anything is published'

placeholders:
	@! $(PLACEHOLDERS)

accuracy: $(VENV)/test.done
	$(BIN)/snakemake -c$(CORES) accuracy

lock:
	uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --extra test --group build --output-file locks/test.txt pyproject.toml
	uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --extra workflow --group build --constraint locks/test.txt --output-file locks/workflow.txt pyproject.toml
	printf '%s\n' $(SLURM_PLUGIN) | uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --no-deps --output-file locks/slurm.txt -

vendor:
	npm pack --silent --pack-destination $(VENDOR) d3@$(D3)
	tar -xzf $(VENDOR)/d3-$(D3).tgz -C $(VENDOR) --strip-components=1 package/LICENSE package/dist/d3.min.js
	mv $(VENDOR)/dist/d3.min.js $(VENDOR)/d3.min.js
	mv $(VENDOR)/LICENSE $(VENDOR)/d3.LICENSE
	rm -r $(VENDOR)/dist $(VENDOR)/d3-$(D3).tgz

lowest:
	uv venv --quiet --clear --python 3.11 $(LOWEST)
	uv pip install --quiet --python $(LOWEST) --resolution lowest-direct --editable '.[workflow]'
	uv pip install --quiet --python $(LOWEST) --editable '.[test]'
	$(LOWEST)/bin/python -m pytest tests/core tests/paper

format: $(VENV)/test.done
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	$(BIN)/snakefmt Snakefile workflow

clean:
	rm -rf results logs .snakemake
