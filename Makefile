# What a learner, a teacher or a contributor does with this course. `make` by itself lists the targets.
# PYTHON=python3.12 chooses the interpreter; ARGS="…" is handed to JupyterLab or pytest.

# Someone who works with ROS has sourced a setup.bash. Its Python packages and libraries must not mix with those in
# .venv, which are of another build. PATH stays, so the genuine `ros2` is still found; what starts it gives it back what
# is taken away here.
unexport PYTHONPATH PYTHONHOME LD_LIBRARY_PATH _ROS_WHEELS_BOOTSTRAP_COMPLETE
# Nor may packages be sent somewhere else, or held at other versions.
unexport PIP_USER PIP_TARGET PIP_PREFIX PIP_CONSTRAINT UV_CONSTRAINT UV_OVERRIDE
# Someone who wants no bytecode beside their own files may have it in this folder, where all of it is git-ignored: the tests
# start hundreds of processes, and each would compile everything anew.
unexport PYTHONDONTWRITEBYTECODE

VENV := .venv/bin/python
# The Python of .venv stays until another one is asked for.
OUTER := $(or $(PYTHON),$(shell test -x $(VENV) && echo $(VENV)),python3)
FITS := import sys; sys.exit(sys.implementation.name != "cpython" or not (3, 10) <= sys.version_info < (3, 15))
SET_UP = $(OUTER) -c '$(FITS)' 2>/dev/null || { echo "The course needs CPython 3.10 to 3.14, and $(OUTER) isn't one:" \
    "install one and name it, as in PYTHON=python3.12 make lab" >&2; exit 1; }; $(OUTER) environment/set_up.py

help:  ## list these targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

# What tests need stays once it is there.
setup:  ## create or repair .venv, with what the lessons need
	@$(SET_UP) .venv requirements.lock $(if $(wildcard .venv/bin/ruff),requirements-dev.lock)

setup-all:  ## the same, with what tests, website and lint need as well
	@$(SET_UP) .venv requirements.lock requirements-dev.lock

lab: setup  ## start JupyterLab on your own copies of the chapters, after the set-up if needed
	@$(VENV) environment/lab.py $(ARGS)

reset: setup  ## make your copy of one chapter fresh again, and keep what was there: make reset CHAPTER=08
	@test -n "$(CHAPTER)" || { echo "Which one? make reset CHAPTER=08" >&2; exit 1; }
	@$(VENV) -m param_tutorial.learner "$(CHAPTER)" $(ARGS)

robot: setup  ## write the package with which a reader ends: make robot DIR=~/ros2_ws/src/my_robot
	@test -n "$(DIR)" || { echo "Where to? make robot DIR=~/ros2_ws/src/my_robot" >&2; exit 1; }
	@$(VENV) -m param_tutorial.learner.finished "$(DIR)"

class: setup  ## a table of a class's progress files, and what to talk about: make class FOLDER=…
	@test -n "$(FOLDER)" || { echo "Where are the files? make class FOLDER=…" >&2; exit 1; }
	@$(VENV) -m param_tutorial.teacher "$(FOLDER)"

hub:  ## start JupyterHub for a class on this machine: see environment/jupyterhub/README.md
	@$(SET_UP) build/jupyterhub requirements.lock requirements-hub.lock
	@build/jupyterhub/bin/python -m jupyterhub --config environment/jupyterhub/jupyterhub_config.py $(ARGS)

# Node.js comes with the packages of the tests; Pyodide, biome and TypeScript from npm. A file biome.jsonc would be taken
# for the settings of environment/ alone.
NODE := .venv/bin/node
JS_TOOLS := environment/node_modules/.package-lock.json
$(JS_TOOLS): environment/package.json environment/package-lock.json | setup-all
	@.venv/bin/npm --prefix environment ci --ignore-scripts --no-audit --no-fund --silent

# Tests mostly wait, so many workers share two cores, and what they wait for may take twice as long.
SUITE := PARAM_TOOLS_PATIENCE=2 $(VENV) -m pytest --dist loadscope --no-loadscope-reorder --nbval

# All but the tests marked `thorough` or `rare`.
test: setup-all  ## run the test suite before you commit: every chapter is a test
	@$(SUITE) -n 8 -m "not thorough and not rare" $(ARGS) tests notebooks

test-all: setup-all $(JS_TOOLS)  ## the same with browsers, the website, builds and a fresh set-up; CI runs it
	@$(SUITE) -n 4 -m "not rare" $(ARGS) tests notebooks

# GitHub runs it once a week. Each part runs also when the one before has failed.
test-rare: setup-all $(JS_TOOLS)  ## what seldom breaks alone: every known answer, two hosts, other Pythons, a machine with ROS
	@failed=0; \
	    $(SUITE) -n 4 -m rare $(ARGS) tests notebooks || failed=1; \
	    $(VENV) -m tests.tools.pythons || failed=1; \
	    exit $$failed

html: setup-all $(JS_TOOLS)  ## make the website in build/html/, with a node in each page and JupyterLab for the browser
	@$(VENV) -m param_tutorial.site $(ARGS)

lite: setup-all $(JS_TOOLS)  ## make the course for any browser, in build/lite/: JupyterLab without a server, with a kernel in the page
	@$(VENV) -m param_tutorial.site.browser.lite $(ARGS)

lesson: setup-all $(JS_TOOLS)  ## make one lesson as one file: make lesson CHAPTER=08
	@test -n "$(CHAPTER)" || { echo "Which one? make lesson CHAPTER=08" >&2; exit 1; }
	@$(VENV) -m param_tutorial.site --lesson "$(CHAPTER)" $(ARGS)

bench: setup-all  ## run the benchmarks
	@$(VENV) -m tests.tools.bench $(ARGS)

lint: setup-all $(JS_TOOLS)  ## check code, notebooks and spelling without running them
	@$(VENV) -m ruff check .
	@$(VENV) -m codespell_lib --dictionary - --dictionary environment/words.txt
	@$(VENV) -m mypy
	@$(VENV) -m tests.tools.notebook_lint notebooks
	@$(NODE) environment/node_modules/.bin/biome check --config-path environment/biome-config.jsonc --error-on-warnings
	@$(NODE) environment/node_modules/.bin/tsc --project environment

# The second lock is a part of the first, at the same versions.
LOCK := environment/requirements
UV_COMPILE = build/uv/bin/uv pip compile --quiet --upgrade --generate-hashes --no-annotate --custom-compile-command "make lock"
COMPILE = $(UV_COMPILE) --universal --python-version 3.10
# A page has no terminal, and its own half of the widgets; what the kernel's wheel asks for is for the build, which runs here.
NOT_IN_A_PAGE := prompt-toolkit wcwidth jupyterlab-widgets widgetsnbextension doit jupyter-core jupyterlite-core pkginfo \
    platformdirs
lock: export UV_CACHE_DIR ?= $(CURDIR)/build/uv-cache
lock: setup-all  ## work out the locks in environment/ anew
	@$(COMPILE) --extra html --group test --output-file $(LOCK)-dev.lock pyproject.toml
	@$(COMPILE) --constraints $(LOCK)-dev.lock --extra course --output-file $(LOCK).lock pyproject.toml
	@$(COMPILE) --constraints $(LOCK)-dev.lock --group hub --output-file $(LOCK)-hub.lock
	@$(COMPILE) --group uv --output-file $(LOCK)-uv.lock
	@$(UV_COMPILE) --python-platform wasm32-pyodide2024 --python-version 3.14 --group page --output-file $(LOCK)-page.lock \
	    $(addprefix --no-emit-package ,$(NOT_IN_A_PAGE))
	@.venv/bin/npm --prefix environment update --package-lock-only --omit-lockfile-registry-resolved --no-audit --no-fund

# my_lessons/ is the learner's, and stays.
clean:  ## remove everything that these targets made, but not your copies of the chapters
	rm -rf .venv build environment/node_modules .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

.PHONY: help setup setup-all lab reset robot class hub test test-all test-rare html lesson bench lint \
    lite lock clean
