# What a learner, a teacher or a contributor does with this course. `make` by itself lists the targets.
# PYTHON=python3.12 chooses the interpreter; ARGS="…" is handed to JupyterLab or pytest.

# Someone who works with ROS has sourced a setup.bash. Its Python packages and libraries must not mix with those in
# .venv, which are of another build. PATH stays, so the genuine `ros2` is still found; it needs what is taken away here
# under its old names, and whoever starts it puts that back.
export PARAM_TUTORIAL_OUTER_PYTHONPATH := $(PYTHONPATH)
export PARAM_TUTORIAL_OUTER_LD_LIBRARY_PATH := $(LD_LIBRARY_PATH)
unexport PYTHONPATH PYTHONHOME LD_LIBRARY_PATH _ROS_WHEELS_BOOTSTRAP_COMPLETE

VENV := .venv/bin/python
LOCK := environment/requirements.lock

help:  ## list these targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

setup:  ## create or repair .venv from the lock file
	@command -v python3 >/dev/null || { echo "There is no python3 here: install CPython 3.10 to 3.14 first." >&2; exit 1; }
	@PYTHON="$(PYTHON)" python3 environment/setup_venv.py

lab: setup  ## start JupyterLab on the course, after the set-up if needed
	@$(VENV) environment/lab.py $(ARGS)

test: setup lint  ## run the whole test suite, as CI does
	@$(VENV) -m pytest -n 4 --dist loadscope --no-loadscope-reorder --nbval $(ARGS) tests notebooks

# All but the tests marked `slow`, the notebooks, and the lint.
test-fast: setup  ## run the tests that take seconds in all, while you edit
	@$(VENV) -m pytest -n 3 --dist loadscope --no-loadscope-reorder -m "not slow" $(ARGS) tests

html: setup  ## make the HTML lessons, in build/html/
	@$(VENV) -m param_tutorial.lessons $(ARGS)

lesson: setup  ## make one lesson as one file: make lesson CHAPTER=06
	@test -n "$(CHAPTER)" || { echo "Which one? make lesson CHAPTER=06" >&2; exit 1; }
	@$(VENV) -m param_tutorial.lessons --lesson "$(CHAPTER)" $(ARGS)

bench: setup  ## run the benchmarks
	@$(VENV) -m tests.tools.bench $(ARGS)

lint: setup  ## check code and notebooks without running them
	@$(VENV) -m ruff check .
	@$(VENV) -m mypy
	@$(VENV) -m tests.tools.notebook_lint notebooks

lock: setup  ## work out environment/requirements.lock anew
	@test -x build/uv/bin/uv || $(VENV) -m pip install --quiet --target build/uv uv
	@build/uv/bin/uv pip compile --quiet --universal --python-version 3.10 --extra test --extra html --extra setup --upgrade \
	    --generate-hashes --no-annotate --custom-compile-command "make lock" --output-file $(LOCK) pyproject.toml

clean:  ## remove everything that these targets made
	rm -rf .venv build .pytest_cache .ruff_cache .hypothesis environment/.setup.lock
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

.PHONY: help setup lab test test-fast html lesson bench lint lock clean
