"""The embedded ``ros2``: the verbs that the course teaches, for machines without an installed ROS.

ros2cli is not on PyPI. These commands take the options of ros2cli 0.32.2 (Jazzy) and print what it prints, byte
for byte where tests/ros2/transcripts says so. Two differences are meant: a call that the node never
answers ends with a sentence after some seconds, and "Node not found" is said only when discovery has finished.

    command  one command, in this process
    param    param list, get, set, describe, dump, load, delete
    node     node list, info
    run      run: the nodes of the course, and the programs of packages that colcon has built
    service  service list
    topic    topic list
    pkg      pkg create: a new Python package; executables, list, prefix
    launch   launch: what a launch file describes
    index    where packages are installed
    session  what the verbs share
    genuine  the installed ros2, where there is one
"""
