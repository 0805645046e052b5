"""The embedded ``ros2``: the most used verbs, for machines without an installed ROS.

ros2cli is not on PyPI. These commands print what ros2cli 0.32.2 (Jazzy) prints: ``param`` and ``node list`` byte for
byte, as 61 recordings in tests/cli/transcripts have it, the others as its source says. They differ on purpose:

- Where the genuine command ends in a traceback, ours says in a sentence what is wrong: a file that is none, an integer
  of more than 64 bits, a bad regular expression. Usage errors and ``--help`` have our own words.
- ``param set`` keeps the text that was typed where the genuine command breaks on it (``@at``, ``a: b``, a date), and
  ``param dump`` writes a parameter ``a.b`` under its full name if there is an ``a``, too.
- A call that the node never answers ends with a sentence after some seconds, instead of never. "Node not found" is said
  only when discovery has finished. There is no daemon, which ``node list -a`` would show, and simulated time makes no
  difference.
- ``run`` and ``launch`` find provided packages (``ros.environment``) without a build, and a notebook's cell rejects a
  command that would keep it busy. ``run`` passes SIGTERM on to its program.
- ``pkg create`` writes Python packages only, and no LICENSE.
- ``launch`` reads files in Python, XML and YAML, with what ``launch/reading.py`` and ``launch/markup.py`` list: what
  602 launch files of 24 public repositories use. It rejects the use of anything else by its name, and it starts no
  components, timers and event handlers, which ``check --launch`` reads. It works out everything before it starts the
  first program, and keeps no log files. What is wrong with a file it says in its own words.
- The commands that the genuine one has not follow its conventions.
- Of other commands, verbs and options, a usage error says that the genuine ros2 has more.

What a command cannot do raises ``CommandFailed`` in any module; ``command`` says it.

    command           one command, in this process
    param             param list, get, set, describe, dump, load, delete
    node              node list
    run               run: the nodes of provided packages, and the programs of packages that colcon has built
    pkg               pkg create: a new Python package
    launch            launch: what a launch file describes
    check             check and describe: parameter files against what nodes declare
    system            snapshot, diff and restore: the parameters of whole systems
    changes           watch and history: every change of a parameter
    panel             panel: the parameter panel as a page in the browser
    system_arguments  what the commands of check, system and changes take for a system, and the files they write
    index             where packages are installed
    session           what the verbs share
"""
