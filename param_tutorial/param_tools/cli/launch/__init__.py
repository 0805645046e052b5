"""ros2 launch: start what a launch file describes, and end it all with Ctrl+C.

``launch`` and ``launch_ros`` are not on PyPI. This reads the same files as long as they keep to what ``reading`` lists,
starts the programs with the same ``--ros-args``, and rejects everything else by its name.
What cannot be done raises ``LaunchFailed``, which ends the launch before a program starts.

    verb           the command: which file, with which arguments
    rehearsal      a launch file without its programs, for ``check --launch``
    reading        reads a launch file; lists what it may import
    importing      runs the Python code of a launch file, with our own classes under the names that it imports
    markup         launch files in XML and YAML
    actions        the actions of launch: arguments, groups, included files, timers, programs
    ros_actions    the actions of launch_ros, among them Node with the command line that it stands for
    conditions     whether an action is carried out
    parameters     the values and files that a Node takes as its parameters
    substitutions  strings that are known only when the launch file is carried out
    text           texts with substitutions in them, such as ``$(var name)``
    context        what is known while a launch file is carried out
    processes      the programs while they run: their output, their end, Ctrl+C
"""
