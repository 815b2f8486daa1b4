# One door to everything: `make help` lists the doors.
PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
PEERS  ?= .peers

.DEFAULT_GOAL := help
.PHONY: help check lint test coverage test-fast update c-check c-test fmu-check wheels wasm bench peers docs figures

help:  ## this list
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*##/\t/' | expand -t 12

$(READY): pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	touch $@

check: $(READY)  ## everything that must hold: style, types, floors, C tests, all tests
	$(MAKE) --jobs=2 lint c-check
	$(MAKE) test

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test: $(READY)  ## all tests
	$(BIN)/python -m pytest -n auto --dist loadgroup

coverage: $(READY)  ## the tests of the floors, which cover at least 95 % of the branches; tracing takes three times as long
	$(BIN)/python -m pytest -n auto --dist loadgroup -m 'not no_cover' --cov --cov-report=term

test-fast: $(READY)  ## the tests of the floors, without models and packaging
	$(BIN)/python -m pytest -n auto tests --ignore=tests/models --ignore=tests/packaging

c-check: $(READY)  ## tests of the C runtime and of the shells of FMUs under sanitizers, warnings of every compiler there is
	$(MAKE) --directory=lagdsl/runtime/c sanitized warnings
	$(MAKE) --directory=lagdsl/fmi/c PYTHON=$(abspath $(BIN)/python) sanitized warnings

c-test: $(READY)  ## the same, with the sanitizer of threads and ten thousand runs under valgrind
	$(MAKE) --directory=lagdsl/runtime/c test

fmu-check: $(READY)  ## every model as an FMU of both versions, through FMPy and whatever other importers there are (half an hour)
	LAGDSL_EXPLORE=1 PEERS=$(PEERS) $(BIN)/python -m pytest -n auto --dist loadgroup tests/fmi

update: $(READY)  ## regenerate what is generated: automaton of the grammar, unit table, functions in C, list of the library, expectations of the corpus
	$(BIN)/python -m lagdsl.syntax.generate
	$(BIN)/python -m lagdsl.units.generate
	$(BIN)/python -m lagdsl.runtime.generate
	LAGDSL_UPDATE=1 $(BIN)/python -m pytest -n auto tests/corpus tests/diagnostics tests/units tests/semantics

wheels: $(READY)  ## wheels of five platforms in dist/, compiled on this machine
	@set -e; for platform in $$($(BIN)/python -m lagdsl.runtime.platforms); do \
	LAGDSL_PLATFORM=$$platform $(BIN)/python -m hatchling build --target wheel; done

wasm: $(READY)  ## the runtime for web pages: dist/lag.wasm
	$(BIN)/python -m lagdsl.runtime.build_wasm dist

bench: $(READY)  ## the figures of benchmarks/README.md, against the peers that `make peers` installed
	PEERS=$(PEERS) $(BIN)/python benchmarks/run.py

peers:  ## an environment of their own for the libraries that the benchmarks compare with, and for importers of FMUs
	test -x $(PEERS)/bin/python || $(PYTHON) -m venv $(PEERS)
	$(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check 'pin>=4' cmeel-eigen mujoco casadi scipy numba scikit-sundae libcosimpy ecospy

$(VENV)/.docs: $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[docs]'
	touch $@

docs: $(VENV)/.docs  ## the site in build/site; broken links are errors
	$(BIN)/python -m sphinx -W --keep-going -q -b html -d build/doctrees docs build/site

figures: $(READY)  ## figures of the documents
	$(BIN)/lag run models/double_pendulum.lag --plot docs/images/double_pendulum.png -o /dev/null
	$(BIN)/lag run models/bouncing_ball.lag --plot docs/images/bouncing_ball.png -o /dev/null
