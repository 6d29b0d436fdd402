# make demo: analyse an example workspace.  make test: run the tests.  make lint: check style and types.
# make facts: extract the facts of the examples again, which are shipped as texts.
# Needs Python 3.10 or newer (choose one with PYTHON=...); everything else is installed into .venv.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PACKAGES := cli composition corpus datalog expectations experiments extractor library models observation reports rules simulation verification
SOURCES := $(PACKAGES) tests benchmarks

COMPILE := $(BIN)/python -m rosarch.models.compile_rules

.PHONY: demo test lint format facts clean

demo: $(VENV)/.installed
	@$(COMPILE)
	$(BIN)/rosarch analyze examples/mobile_base

test: $(VENV)/.installed-dev
	@$(COMPILE)
	$(BIN)/python -m pytest -n auto --dist worksteal $(ARGS)

# mypy looks for folders that are called as the packages are: rosarch.cli is cli/
lint: $(VENV)/.installed-dev
	$(BIN)/ruff check $(SOURCES)
	$(BIN)/ruff format --check $(SOURCES)
	@mkdir -p $(VENV)/typed/rosarch
	@for package in $(PACKAGES); do ln -sfn "$(CURDIR)/$$package" "$(VENV)/typed/rosarch/$$package"; done
	MYPYPATH=$(VENV)/typed $(BIN)/mypy --package rosarch

format: $(VENV)/.installed-dev
	$(BIN)/ruff check --fix $(SOURCES)
	$(BIN)/ruff format $(SOURCES)

facts: $(VENV)/.installed
	rm -f examples/facts/*.txt
	@for folder in examples/*/src; do \
	    example=$${folder%/src}; $(BIN)/rosarch extract $$example --text --out examples/facts/$${example#*/}.txt || exit 1; done

clean:
	rm -rf $(VENV) build rules/compiled *.egg-info .mypy_cache .pytest_cache .ruff_cache

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 10) and "rosarch needs Python 3.10 or newer; try make PYTHON=python3.12")'
	$(PYTHON) -m venv $(VENV)

$(VENV)/.installed: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e .
	@$(COMPILE)
	@touch $@

$(VENV)/.installed-dev: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	@$(COMPILE)
	@touch $@ $(VENV)/.installed
