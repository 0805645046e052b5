"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.3."""

WRONG = {
    '7.3a': [
        ([("    '-p speed:=400',\n",
           ''),
          ("    '--params-file fast.yaml',\n",
           "    '-p speed:=400',\n    '--params-file fast.yaml',\n")],
         1, 'it is `80`. Which block is opened last?'),
        ([("    '--params-file fast.yaml',\n    '--params-file slow.yaml',\n",
           "    '--params-file slow.yaml',\n    '--params-file fast.yaml',\n")],
         1, "it is `'fast'`. Both files write into the same block"),
        ([("    '--params-file fast.yaml',\n", '')],
         0, "the list is `['--params-file slow.yaml', '-p speed:=400']`"),
        ([('400', '300')],
         0, "'-p speed:=300']`"),
        ([("    '-p speed:=400',\n", "    '-p speed:=400',\n    '-p speed:=400',\n")],
         0, "the list is `['--params-file fast.yaml', '--params-file"),
        ([("'-p speed:=400'", '400')],
         0, "the list is `['--params-file fast.yaml', '--params-file"),
        ([('-p speed', '-p robot:speed')],
         0, "'-p robot:speed:=400']`"),
        ([('sources = [', 'sources = {'), ("400',\n]", "400',\n}")],
         0, 'the check was given a `set`'),
    ],
    '7.3b': [
        ([("{\n    'mixed.yaml': 300", "{\n    'mixed.yaml': 200")],
         7, 'The later block wins'),
        ([("'mixed.yaml, -p 400': 400,\n    '-p", "'mixed.yaml, -p 400': 200,\n    '-p")],
         7, 'opened last?'),
        ([("'-p 400, mixed.yaml': 200", "'-p 400, mixed.yaml': 300")],
         7, 'opened first'),
        ([("'every.yaml, mixed.yaml': 200", "'every.yaml, mixed.yaml': 300")],
         7, 'already opened that block'),
        ([("'mixed.yaml, any.yaml': 250", "'mixed.yaml, any.yaml': 200")],
         7, 'The more specific name does not win'),
        ([("'any.yaml, mixed.yaml, -p 400': 400", "'any.yaml, mixed.yaml, -p 400': 300")],
         7, 'another value'),
        ([("any.yaml, -p 400': 250", "any.yaml, -p 400': 400")],
         7, 'goes into the first block'),
        ([("'lab.yaml': 100", "'lab.yaml': 150")],
         7, 'not in the laboratory'),
        ([("{\n    'mixed.yaml': 300", "{\n    'mixed.yaml': '300'")],
         7, 'In quotes it is a string'),
        ([("'lab.yaml': 100", "'lab.yaml': 100.0")],
         7, 'Written like this, it is a double'),
    ],
    '7.3c': [
        ([('/lab/right/gripper:\n  ros__parameters:\n', '/lab/right/gripper:\n')],
         0, 'Cannot have a value before ros__parameters at line 7'),
        ([('/lab/*/gripper', '/*/gripper')],
         1, '`force_n` is `5.0`'),
        ([('/lab/*/gripper', '/lab/left/gripper')],
         4, '`speed_mmps` is `10`'),
        ([('/lab/*/gripper', '/lab/**')],
         4, '`force_n` is `12.0`'),
        ([('/lab/*/gripper', '/**/gripper')],
         4, '`force_n` is `12.0`'),
        ([('12.0', '12')],
         1, "to '12' of type 'INTEGER', expecting type 'DOUBLE'"),
        ([('40', '40.0')],
         1, "to '40.0' of type 'DOUBLE', expecting type 'INTEGER'"),
        ([('/lab/*/gripper', '/lab/l*/gripper')],
         0, 'it cannot'),
        ([('    force_n: 12.0\n', '    force_n: &force 12.0\n'), ('20.0', '*force')],
         0, 'it cannot: Will not support aliasing'),
    ],
}

RIGHT = {
    '7.3a': [
        [("    '-p speed:=400',\n",
          ''),
         ("    '--params-file slow.yaml',\n",
          "    '-p speed:=400',\n    '--params-file slow.yaml',\n")],
        [("'-p speed", "'-p  speed")],
        [("'--params-file fast.yaml'", "'--params-file ' + 'fast.yaml'")],
        [('sources = [', 'sources = ('), ("400',\n]", "400',\n)")],
    ],
    '7.3c': [
        [('/lab/*/gripper', '/lab/**/gripper')],
        [('/lab/*/gripper', 'lab/*/gripper'), ('/lab/right/gripper', '"/**/right/gripper"')],
        [('/lab/*/gripper:\n'
          '  ros__parameters:\n'
          '    force_n: 12.0\n'
          '    speed_mmps: 40\n'
          '/lab/right/gripper:\n'
          '  ros__parameters:\n'
          '    force_n: 20.0\n',
          'lab:\n'
          '  "*":\n'
          '    gripper: {ros__parameters: {force_n: 1.2e1, speed_mmps: 40}}\n'
          '  right:\n'
          '    gripper: {ros__parameters: {force_n: 20.0}}\n')],
    ],
}
