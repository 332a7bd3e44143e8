# make demo    sets everything up, then runs the whole system once (WORLD=street: in a street)
# make test    sets everything up, then runs the checks and tests (a few minutes)
# Everything lives in .venv; nothing is reinstalled until pyproject.toml changes.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
# not from the environment, where PORT often means something else; `make demo PORT=3795` works
PORT = 3794
# `make demo WORLD=street`: over a kerb to a pipe with wires
WORLD = yard
# each worker begins with a third of the tests, so that those of a file share its fixtures
PYTEST = $(BIN)/pytest -n 3 --dist worksteal
PYTEST_ARGS ?=
CASES ?= 10000000
JOBS ?= 2
SECONDS ?= 600
ATTACK_ARGS ?=
# Many container images set it; then every process that a test starts would compile its modules again.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help setup dev demo cell test test-slow test-together test-alone test-long coverage check lint types imports docs unit wheel-test bench fuzz soak attack security audit format generate clean

help:
	@sed -n 's/^# //p' Makefile | head -3
	@echo "others: test-slow test-long coverage lint types imports docs unit wheel-test bench fuzz soak attack security audit format generate clean (see CONTRIBUTING.md)"

$(VENV)/.installed: pyproject.toml tools/setup_venv.sh
	@PYTHON=$(PYTHON) tools/setup_venv.sh $(VENV) user
	@touch $@

$(VENV)/.developing: $(VENV)/.installed
	@PYTHON=$(PYTHON) tools/setup_venv.sh $(VENV) developer
	@touch $@

setup: $(VENV)/.installed
dev: $(VENV)/.developing

demo: setup
	@$(BIN)/jauspy demo --port $(PORT) --world $(WORLD)

cell: dev
	$(BIN)/jauspy cell demo --seed 7 --record cell_out/demo.mp4
	$(BIN)/jauspy cell all --output cell_out $(CELL_ARGS)

# the checks two at a time, and then the tests alone: some of them measure time
test: dev
	@$(MAKE) --no-print-directory -j2 --output-sync=target check wheel-test
	@$(MAKE) --no-print-directory unit

# slow tests too: the others run neither the console's pages nor whole tasks of the cell
coverage: dev
	$(PYTEST) -m '' --cov --cov-report=term $(PYTEST_ARGS)

# first those that share the machine, and then one by one those that need it for themselves
test-slow: dev
	$(MAKE) --no-print-directory test-together
	$(MAKE) --no-print-directory test-alone

test-together: dev
	$(PYTEST) -m 'slow and not alone and not long' $(PYTEST_ARGS)

# only the files that have such tests: to read all others takes longer than many a test
test-alone: dev
	$(BIN)/pytest -m 'slow and alone and not long' $(PYTEST_ARGS) $(shell grep -rlE --include='test_*.py' 'mark\.alone|helpers\.browser' tests)

# what CI has no time for: about an hour and a half; before a release
test-long: dev
	$(PYTEST) -m 'long and not alone' $(PYTEST_ARGS)
	$(BIN)/pytest -m 'long and alone' $(PYTEST_ARGS)

check: types docs lint imports security

lint: dev
	$(BIN)/ruff check
	$(BIN)/ruff format --check

types: dev
	$(BIN)/mypy

imports: dev
	$(BIN)/lint-imports

# constructs of Python that attackers like; what is left out, and why, is in pyproject.toml
security: dev
	$(BIN)/bandit -q -c pyproject.toml -r src tools

# known vulnerabilities of the packages in .venv; needs the network, and without it says that it checked nothing
audit: dev
	$(BIN)/python tools/audit_packages.py

# the documentation as a web site, for which a warning is an error
docs: dev
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build -q --strict

unit: dev
	$(PYTEST) $(PYTEST_ARGS)

wheel-test: dev
	$(BIN)/python tools/wheel_test.py

bench: dev
	@for script in tools/bench/[!_]*.py; do echo "== $$script"; $(BIN)/python $$script || exit 1; done

fuzz: dev
	$(BIN)/jauspy fuzz codec tests/golden/sae_management.hex --cases $(CASES) --jobs $(JOBS) --resume findings/progress.json

soak: dev
	$(BIN)/python tools/soak.py --seconds $(SECONDS)

# every attack of tools/attack on running victims; as root in network namespaces, else on the loopback interface
attack: dev
	$(BIN)/python -m tools.attack --seconds $(SECONDS) $(ATTACK_ARGS)

format: dev
	$(BIN)/ruff check --fix
	$(BIN)/ruff format

generate: dev
	$(BIN)/python tools/generate_messages.py
	$(BIN)/python tools/generate_sync.py
	$(BIN)/python tools/translate.py

clean:
	rm -rf $(VENV) dist build site .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache
