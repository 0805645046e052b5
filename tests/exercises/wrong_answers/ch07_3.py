"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.3."""

_SPACE = "namespace=LaunchConfiguration('namespace')"
_DECLARE = ("        DeclareLaunchArgument('namespace', default_value='', description='The name of the robot.'),\n")

WRONG = {
    '7.3a': [
        ([('/**/driver:', '/driver:')], 0, 'it is `0.5`. That is not what the file says'),
        ([('/**/driver:', '/**:')], 3, 'its key matches every name'),
        ([(f', {_SPACE}', '')], 2, 'it is `/driver`. Does `Node` use the argument?'),
        ([("default_value='', d", "default_value='left', d")], 3, 'What is the default of `namespace`?'),
        ([('/**/driver:', '/*/driver:')], 0, 'Does its key match this name?'),
        ([('/**/driver:', '/**/drive:')], 0, 'That is not what the file says'),
        ([(_SPACE, "namespace='left'")], 2, 'it is `/left/driver`'),
        ([(_DECLARE, '')], 3, 'namespace'),
        ([("LaunchConfiguration('params_file')", 'ours')], 3, 'Is `params_file` still declared, and used?'),
        ([("executable='driver_node'", "executable='tuner_node'")], 2, 'it starts `tuner_node`'),
        ([('  ros__parameters:', '  parameters:')], 0, 'the file has no ros__parameters'),
        ([('/**/driver:', '"/**/driver:')], 0, 'it cannot'),
    ],
    '7.3b': [
        ([("    '-p max_speed_mps:=0.7',\n",
           ''),
          ("    '--params-file fast.yaml',\n",
           "    '-p max_speed_mps:=0.7',\n    '--params-file fast.yaml',\n")],
         1, 'it is `0.4`. Which block is opened last?'),
        ([("    '--params-file fast.yaml',\n    '--params-file slow.yaml',\n",
           "    '--params-file slow.yaml',\n    '--params-file fast.yaml',\n")],
         1, 'it is `0.6`. Both files write into the same block'),
        ([("    '--params-file fast.yaml',\n", '')],
         0, "the list is `['--params-file slow.yaml', '-p max_speed_mps:=0.7']`"),
        ([('0.7', '0.8')],
         0, "'-p max_speed_mps:=0.8']`"),
        ([("    '-p max_speed_mps:=0.7',\n", "    '-p max_speed_mps:=0.7',\n    '-p max_speed_mps:=0.7',\n")],
         0, "the list is `['--params-file fast.yaml', '--params-file"),
        ([("'-p max_speed_mps:=0.7'", '0.7')],
         0, "the list is `['--params-file fast.yaml', '--params-file"),
        ([('-p max', '-p driver:max')],
         0, "'-p driver:max_speed_mps:=0.7']`"),
        ([('sources = [', 'sources = {'), ("0.7',\n]", "0.7',\n}")],
         0, 'the check was given a `set`'),
    ],
    '7.3c': [
        ([('/left/driver:', '/left/drive:')], 1, 'Which keys match'),
        ([('1.0', '1')], 0, "to '1' of type 'INTEGER', expecting type 'DOUBLE'"),
        ([('/left/driver:', '/**/driver:')], 2, 'Which of its keys match `/driver`?'),
        ([('rate_hz', 'rate')], 2, 'it is `10`'),
        ([('  ros__parameters:\n', '')], 0, 'it cannot'),
        ([('/left/driver:', '/driver:')], 1, 'it is `0.5`'),
        ([('max_speed_mps: 0.3', 'max_speed_mps: 3.0')], 0, 'out of range'),
        ([('/left/driver:', 'driver:')], 1, 'Which keys match'),
    ],
}

RIGHT = {
    '7.3a': [
        [('/**/driver:', '"/**/driver":')],
        [('/**/driver:\n  ros__parameters:\n', '/**:\n  driver:\n   ros__parameters:\n')],
        [(_SPACE, "namespace=[LaunchConfiguration('namespace')]")],
    ],
    '7.3b': [
        [("    '-p max_speed_mps:=0.7',\n",
          ''),
         ("    '--params-file slow.yaml',\n",
          "    '-p max_speed_mps:=0.7',\n    '--params-file slow.yaml',\n")],
        [("'-p max", "'-p  max")],
        [("'--params-file fast.yaml'", "'--params-file ' + 'fast.yaml'")],
        [('sources = [', 'sources = ('), ("0.7',\n]", "0.7',\n)")],
    ],
    '7.3c': [
        [('/left/driver:', 'left/driver:')],
        [('/left/driver:', '/left/**:')],
        [('/left/driver:\n  ros__parameters:\n', '/left:\n  driver:\n   ros__parameters:\n')],
    ],
}
