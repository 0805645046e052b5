"""The embedded ``ros2``: the verbs that the course teaches, for machines without an installed ROS.

ros2cli is not on PyPI. These commands take the options of ros2cli 0.32.2 (Jazzy) and print what it prints, byte
for byte where tests/ros2/transcripts says so. Two differences are meant: a call that the node never
answers ends with a sentence after some seconds, and "Node not found" is said only when discovery has finished. The
commands that the genuine one has not (``genuine.OWN_COMMANDS``) follow its conventions, and extend it where it is.

    command    one command, in this process
    param      param list, get, set, describe, dump, load, delete
    node       node list
    run        run: the nodes of the course, and the programs of packages that colcon has built
    pkg        pkg create: a new Python package
    launch     launch: what a launch file describes
    check      check and describe: parameter files against what nodes declare
    system     snapshot, diff and restore: the parameters of whole systems
    changes    watch and history: every change of a parameter
    sources    what those commands take for a system
    isolated   a program in a ROS domain of its own, to describe its nodes
    extension  those commands for the genuine ros2
    index      where packages are installed
    session    what the verbs share
    genuine    the installed ros2, where there is one
"""
