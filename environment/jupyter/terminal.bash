# What bash reads when a terminal opens in JupyterLab: first the learner's own start-up file, and then what makes
# `python` the course's, whatever that file does to the PATH, or calls `python`.
if [ -f ~/.bashrc ]; then
    . ~/.bashrc
fi
unalias python python3 pip 2>/dev/null
unset -f python python3 pip
export PATH="$PARAM_TUTORIAL_PROGRAMS:$PATH"
