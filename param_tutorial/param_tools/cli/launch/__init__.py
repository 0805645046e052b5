"""ros2 launch: start what a launch file describes, and end it all with Ctrl+C.

``launch`` and ``launch_ros`` are not on PyPI. This reads the same files as long as they keep to what
``reading.MODULES`` lists, starts the programs with the same ``--ros-args``, and rejects everything else by its name.

    verb           the command: which file, with which arguments
    reading        runs a launch file, with our own classes under the names that it imports
    actions        the actions, among them Node with the command line that it stands for
    parameters     the values and files that a Node takes as its parameters
    substitutions  strings that are known only when the launch file is carried out
    context        what is known while a launch file is carried out
    processes      the programs while they run: their output, their end, Ctrl+C
"""
