# What bash reads when a terminal opens in JupyterLab: first the learner's own start-up file, and then what makes
# `python` the course's, whatever that file does to the PATH, or calls `python`, and `ros2` where ROS is not installed.
if [ -f ~/.bashrc ]; then
    . ~/.bashrc
fi
unalias python python3 pip 2>/dev/null
unset -f python python3 pip
export PATH="$PARAM_TUTORIAL_PROGRAMS:$PATH:$PARAM_TOOLS_STAND_IN"
case $PARAM_TUTORIAL_PROGRAMS in
*[[:space:]]*)
    # A program that is built starts with the path of the Python that built it, which Linux ends at the first space.
    colcon() {
        echo "What colcon builds with this Python cannot be started, because its path has a space in it:" \
            "$PARAM_TUTORIAL_PROGRAMS. Move the course's folder to a path without one." >&2
        return 1
    }
    ;;
esac
