#!/bin/bash
# The course on Binder, or in any image that repo2docker builds; .binder/ calls this. Open it with
# ?urlpath=lab/tree/my_lessons/index.md after the address. Not run by the course's authors so far: see README.md here.
set -euo pipefail

case $1 in
build)
    # As in .venv: the locked packages and no others, although some of them ask for more.
    pip install --no-cache-dir --no-deps --require-hashes --requirement environment/requirements.lock
    pip install --no-cache-dir --no-deps --no-build-isolation --editable .
    ;;
start)
    shift
    export JUPYTER_CONFIG_PATH=$PWD/environment/jupyter PARAM_TUTORIAL_PROGRESS=$PWD/my_lessons/progress.json
    python -c 'from pathlib import Path; from param_tutorial.learner.copies import Copies; Copies(Path.cwd()).deliver()'
    exec "$@"
    ;;
esac
