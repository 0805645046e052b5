"""ros2 launch: start what a launch file describes, and end it all with Ctrl+C.

``launch`` and ``launch_ros`` are not on PyPI. This reads the same files, as far as they keep to what the lessons use,
and starts the programs with the same ``--ros-args``; everything else is rejected by its name.

    verb           the command: which file, with which arguments
    reading        runs a launch file, with stand-ins for the modules that it imports
    description    the actions of launch and launch_ros, and the command lines that they stand for
    values         which values a launch file may give to a parameter, and what becomes of each
    substitutions  strings that are known only when the launch file is carried out
    processes      the programs while they run: their output, their end, Ctrl+C
"""
