# One door to everything: `make help` lists the doors.
PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
PEERS  ?= .peers

.DEFAULT_GOAL := help
.PHONY: extension help check check-all lint test test-all coverage test-fast update c-check runtime-objects shell-objects c-runtime c-shells \
  c-test fmu-check wheels page page-check bench peers docs figures

# Many processes import the same modules: the first one that does compiles them for all, whatever the environment says.
export PYTHONDONTWRITEBYTECODE :=

help:  ## this list
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*##/\t/' | expand -t 12

# uv installs in half of pip's CPU time (docs/adr/0035). Only pip knows what was set for pip, such as an index of one's own: it
# installs where uv cannot. Modules that nothing imports need not be compiled.
PIP    := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile
UV     := $(BIN)/uv pip install --quiet --system-certs --python $(BIN)/python

$(READY): pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(PIP) uv
	$(UV) --editable '.[dev]' || $(PIP) --editable '.[dev]'
	touch $@

check:  ## what must hold before a merge: style, types, floors, C under sanitizers, tests with one of each kind
	$(MAKE) --jobs=3 lint c-check test

check-all:  ## everything, in an hour: `check` with all models, all compilers that are installed, threads, valgrind; the site
	$(MAKE) --jobs=3 lint c-test test-all
	$(MAKE) docs

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

# The jobs of this make are none of those that tests start. Every core has a process: threads of OpenBLAS would wait for work on it.
ALONE := env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL OPENBLAS_NUM_THREADS=1

# Tests of a file share what they compile. In the order of their names many small ones come last: all processes end together.
# A process that crashes ends the run: pytest-xdist would wait for the rest of its files for ever.
SPREAD := -n auto --dist loadfile --no-loadscope-reorder --max-worker-restart=0

# Assertions that tell their values take two thirds of the time in which a fresh checkout compiles its tests. Tests that fail run
# again with them, and the run has failed whatever they do then.
test: shell-objects  ## the tests, with one of each kind where they repeat a rule
	$(ALONE) $(BIN)/python -m pytest $(SPREAD) --assert=plain || \
	{ $(ALONE) $(BIN)/python -m pytest --last-failed --last-failed-no-failures=none; false; }

test-all: shell-objects  ## the tests, with every model
	$(ALONE) LAGDSL_ALL=1 $(BIN)/python -m pytest $(SPREAD)

coverage: $(READY)  ## all tests of the floors, which cover at least 95 % of the branches; tracing takes three times as long
	LAGDSL_ALL=1 $(BIN)/python -m pytest $(SPREAD) -m 'not no_cover' --cov --cov-report=term

test-fast: $(READY)  ## the tests of the floors, without models and packaging
	$(BIN)/python -m pytest $(SPREAD) tests --ignore=tests/models --ignore=tests/packaging

c-check: c-runtime c-shells  ## tests of the C runtime and of the shells of FMUs under sanitizers

# The tests in Python link these objects, too. The runtime needs no package: it is compiled and tested while they are installed.
runtime-objects:
	$(MAKE) --directory=lagdsl/engines/runtime/c objects

shell-objects: runtime-objects $(READY)
	$(MAKE) --directory=lagdsl/exchange/fmi/c PYTHON=$(abspath $(BIN)/python) objects

c-runtime: runtime-objects
	$(MAKE) --directory=lagdsl/engines/runtime/c sanitized

c-shells: c-runtime shell-objects
	$(MAKE) --directory=lagdsl/exchange/fmi/c PYTHON=$(abspath $(BIN)/python) sanitized

c-test: c-check  ## the same, with warnings of every compiler there is, the sanitizer of threads and ten thousand runs under valgrind
	$(MAKE) --directory=lagdsl/engines/runtime/c test
	$(MAKE) --directory=lagdsl/exchange/fmi/c PYTHON=$(abspath $(BIN)/python) test

fmu-check: $(READY)  ## every model as an FMU of both versions, through FMPy and whatever other importers there are (two hours)
	LAGDSL_EXPLORE=1 PEERS=$(PEERS) $(BIN)/python -m pytest $(SPREAD) tests/exchange/fmi

update: $(READY)  ## regenerate what is generated: automaton of the grammar, grammars of editors, unit table, functions in C, list of the library, expectations of the corpus
	$(BIN)/python -m lagdsl.language.syntax.generate
	$(BIN)/python -m lagdsl.foundation.units.generate
	$(BIN)/python -m lagdsl.engines.runtime.generate
	$(BIN)/python -m lagdsl.language.highlight.generate
	$(BIN)/python -m lagdsl.interfaces.lsp.snippets editors/vscode/snippets/lag.json
	LAGDSL_UPDATE=1 $(BIN)/python -m pytest -n auto tests/corpus tests/foundation/diagnostics tests/docs tests/foundation/units tests/language/semantics

wheels: $(READY)  ## wheels of five platforms in dist/, compiled on this machine
	@set -e; for platform in $$($(BIN)/python -m lagdsl.engines.runtime.building.platforms); do \
	LAGDSL_PLATFORM=$$platform $(BIN)/python -m hatchling build --target wheel; done

PAGE := lagdsl/documents/page/web

page: $(READY)  ## what living pages carry, from the TypeScript and C sources: needs node
	cd $(PAGE) && npm ci --silent && npx tsc --noEmit && node build.mjs
	$(BIN)/python -m lagdsl.engines.runtime.build_wasm $(PAGE)/dist

extension:  ## the extension for VS Code, editors/vscode/lagdsl.vsix: needs node
	cd editors/vscode && npm ci --silent && npm run package

page-check: $(READY)  ## pages of all models in a real browser: needs node and Chromium
	$(PIP) playwright
	LAGDSL_ALL=1 $(BIN)/python -m pytest -n auto tests/documents/page

bench: $(READY)  ## the figures of benchmarks/README.md, against the peers that `make peers` installed; living pages need Chromium
	$(PIP) playwright
	PEERS=$(PEERS) $(BIN)/python benchmarks/run.py

peers:  ## an environment of their own for the libraries that the benchmarks compare with, and for importers of FMUs
	test -x $(PEERS)/bin/python || $(PYTHON) -m venv $(PEERS)
	$(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check 'pin>=4' cmeel-eigen mujoco casadi scipy numba scikit-sundae libcosimpy ecospy fmuloader fmu-manipulation-toolbox jax rumoca pymoca

$(VENV)/.docs: $(READY)
	$(PIP) --editable '.[docs]'
	touch $@

docs: $(VENV)/.docs  ## the site in build/site; broken links are errors
	$(BIN)/python -m sphinx -W --keep-going -q -b html -d build/doctrees docs build/site

figures: $(READY)  ## figures of the documents
	$(BIN)/lag run models/double_pendulum.lag --plot docs/images/double_pendulum.png -o /dev/null
	$(BIN)/lag run models/bouncing_ball.lag --plot docs/images/bouncing_ball.png -o /dev/null
	$(BIN)/lag run models/bouncing_ball.lag --plot docs/images/bouncing_ball_phase.png --show h --xy h 'der(h)' -o /dev/null
	$(BIN)/lag run models/stick_slip_belt.lag --plot docs/images/stick_slip_belt.png --show x --show 'der(x)' --show carried -o /dev/null
	$(BIN)/python docs/figures/scene.py
	$(BIN)/python docs/figures/problems.py
