# One command to run it, one to test it; both set the machine up first.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

# The console is built with Node; the service runs without it.
NODE_NEEDED := 20.19
NODE_FITS := $(shell node -e 'const [a, b] = process.versions.node.split(".").map(Number); console.log(a > 20 || (a === 20 && b >= 19))' 2>/dev/null)
CONSOLE := web/dist/index.html
CONSOLE_SOURCES := $(shell find web/src core/words -type f ! -name '*.py*') web/index.html web/vite.config.ts web/tsconfig.json

.PHONY: run test run-tests test-thorough check check-style check-types check-console bench wheel clean

run: $(VENV)/.run $(if $(filter true,$(NODE_FITS)),$(CONSOLE),without-console)
	$(BIN)/heft serve

test: check run-tests

run-tests: $(CONSOLE) $(VENV)/.compiled
	$(BIN)/python -m pytest -n 3 --dist worksteal --ignore=tests/web  # one more than cores: tests of the service wait much
	$(BIN)/python -m pytest -n 2 --dist loadfile tests/web  # by themselves: browsers that draw without a graphics card keep the cores busy

test-thorough: $(VENV)/.dev $(CONSOLE)
	$(BIN)/python -m pytest -n 2 --dist worksteal -m thorough --ignore=tests/web
	$(BIN)/python -m pytest -n 2 --dist loadfile -m thorough tests/web

check: check-style check-types check-console

check-style: $(VENV)/.dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

check-types: $(VENV)/.dev
	$(BIN)/mypy

check-console: web/node_modules/.ready $(VENV)/.run
	$(BIN)/heft openapi web/openapi.json
	cd web && npm run --silent types -- --check && npm run --silent check

wheel: $(VENV)/.run $(CONSOLE)
	rm -rf server/console && cp -r web/dist server/console
	$(BIN)/python -m pip wheel --quiet --no-deps --wheel-dir dist . ; rm -rf server/console

bench: $(VENV)/.dev $(CONSOLE)
	$(BIN)/python -m bench

clean:
	rm -rf $(VENV) web/node_modules web/dist

.PHONY: without-console node

without-console:
	@echo "The operator console is not built: that needs Node $(NODE_NEEDED) or later (nodejs.org). The service starts without it."

node:
	@[ "$(NODE_FITS)" = true ] || { echo "The operator console needs Node $(NODE_NEEDED) or later to be built and checked; found $$(node --version 2>/dev/null || echo none). Install it from nodejs.org."; exit 2; }

# What is compiled at its first call: once, not by each of the processes that test at the same time.
$(VENV)/.compiled: $(VENV)/.run
	out=$$(mktemp -d) && $(BIN)/heft run lwr4_bench --payload steel_block --out $$out/run >/dev/null && \
		$(BIN)/heft diagnose $$out/run >/dev/null && rm -rf $$out
	@touch $@

web/node_modules/.ready: web/package-lock.json web/package.json | node
	cd web && npm ci --loglevel=error
	@touch $@

$(CONSOLE): $(CONSOLE_SOURCES) web/node_modules/.ready
	cd web && npm run --silent build

$(VENV)/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "Heft needs Python 3.11 or later; $(PYTHON) is $$($(PYTHON) --version 2>&1). Set PYTHON=python3.11 or the like."; exit 2; }
	$(PYTHON) -m venv $(VENV)

$(VENV)/.run: requirements.txt pyproject.toml | $(VENV)/bin/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --editable .
	@touch $@

$(VENV)/.dev: requirements-dev.txt $(VENV)/.run
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements-dev.txt
	@touch $@
