# make demo: analyse an example workspace.  make test: run the tests.  make lint: check style and types.
# make docs: build the documentation as a site, in build/site; a dead link fails.
# make facts: extract the facts of the examples again, which are shipped as texts.
# Needs Python 3.10 or newer (choose one with PYTHON=...); everything else is installed into .venv.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
COMPILE := $(BIN)/python -m rosarch.rule_programs.compile

.PHONY: demo test lint format docs facts clean

demo: $(VENV)/.installed
	@$(COMPILE)
	$(BIN)/rosarch analyze examples/mobile_base

test: $(VENV)/.installed-dev
	@$(COMPILE)
	$(BIN)/python -m pytest -n auto --dist worksteal $(ARGS)

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy

format: $(VENV)/.installed-dev
	$(BIN)/ruff check --fix
	$(BIN)/ruff format

docs: $(VENV)/.installed-docs
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet

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

$(VENV)/.installed-docs: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[docs]'
	@touch $@

$(VENV)/.installed-dev: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	@rm -rf $(VENV)/typed && mkdir $(VENV)/typed && ln -s ../.. $(VENV)/typed/rosarch # where mypy and editors look for rosarch.cli
	@$(COMPILE)
	@touch $@ $(VENV)/.installed
