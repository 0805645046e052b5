"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.5."""

_MEND = """    if isinstance(before, list):
        return len(before) == len(after) and all(same_value(*pair) for pair in zip(before, after))
    if isinstance(before, float) and math.isnan(before):
        return math.isnan(after)
    return before == after"""
_THEN, _SET, _COMPARE, _RESTORE = (
    'then = ParameterSet.of(client)\n', "client.set_parameters_atomically({'low_c': -30, 'high_c': -10})\n",
    'changed = compare(then, client)\n', 'restore(client, then)\n')
_BODY = """    defaults = ParameterSet.defaults(node_class)
    wanted = {name: value for name, value in defaults.items() if name not in keep}
    return [outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']"""

WRONG = {
    '10.5b': [
        ([(_THEN + _SET, _SET + _THEN)], 0, 'it is empty'),
        ([(_RESTORE, '')], 1, '`low_c` is `-30` and was `-5`'),
        ([(_THEN, ''), (_RESTORE, _RESTORE + _THEN)], 0, "name 'then' is not defined"),
        # Back to the defaults of this robot, which another one does not have.
        ([(_RESTORE, "restore(client, {'low_c': -5, 'high_c': 40})\n")], 1, '`low_c` is `-5` and was `10`'),
        ([(_COMPARE, 'changed = compare(client, then)\n')], 1, '`low_c` from `-30` to `-5`'),
        ([(_COMPARE, 'compare(then, client)\n')], 1, 'it is `None`'),
        # One by one.
        ([(_SET, "client.set_parameters({'low_c': -30, 'high_c': -10})\n")], 1,
         'the requests are, one after the other, `low_c = -30`; `high_c = -10`; `'),
        ([(_SET, "client.set_parameter('low_c', -30)\nclient.set_parameter('high_c', -10)\n")], 1,
         '`low_c = -30`; `high'),
        # Never ends.
        ([(_RESTORE, 'while True: pass\n')], 0, 'was still running'),
    ],
    '10.5a': [
        ([(_MEND, _MEND[_MEND.index('    if isinstance(before, float)'):])], 0, 'returned `True`'),
        ([('same_value(*pair)', 'type(pair[0]) is type(pair[1]) and pair[0] == pair[1]')], 1, 'returned `False`'),
        ([('isinstance(before, float) and ', '')], 0, 'TypeError: must be real number, not str'),
        ([(_MEND, '    return str(sorted(before)) == str(sorted(after))\n')], 0, 'is not iterable'),
        # Only the first elements.
        ([('all(same_value(*pair) for pair in zip(before, after))', 'same_value(before[:1], after[:1])')], 0,
         'RecursionError'),
    ],
    '10.5c': [
        ([("if outcome.word != 'set'", "if outcome.word == 'set'")], 1, 'it returned `['),
        ([('if name not in keep', '')], 2, "it is `'white'`"),
        ([('outcome.name for', 'outcome for')], 2, 'it returned `[Outcome'),
        ([("[outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']",
           'restore(node, wanted).complete')], 1, 'it returned `True`'),
        ([('ParameterSet.defaults(node_class)', 'ParameterSet.of(node)')], 0, 'it is `1`'),
        ([('return [outcome', 'print([outcome'), ("!= 'set']", "!= 'set'])")], 1, 'it returned `None`'),
        # By the beginning of a name.
        ([('if name not in keep', 'if not name.startswith(tuple(keep))')], 2, 'it is `4000`'),
        ([('    return [outcome', '    keep.clear()\n    return [outcome')], 1, 'the function has made it `[]`'),
        # An end with the old node: a new one would have its defaults.
        ([(_BODY, '    node.destroy_node()\n    return []')], 0,
         'the function has put an end to the node'),
        # Compares with ==, for which nan differs from itself.
        ([("    return [outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']",
           """    restore(node, wanted)
    held = ParameterSet.of(node)
    return [name for name in wanted if held[name] != wanted[name]]""")], 2, "it returned `['offset_c']`"),
    ],
}

RIGHT = {
    '10.5b': [
        [("client.set_parameters_atomically({'low_c': -30, 'high_c': -10})",
          'winter = dict(high_c=-10, low_c=-30)\nclient.set_parameters_atomically(winter).raise_for_reason()')],
        # A try before it, and other ways back.
        [(_SET, "client.set_parameter('low_c', -6)\n" + _SET)],
        [(_RESTORE, "client.set_parameters({'high_c': then['high_c'], 'low_c': then['low_c']})\n")],
        [(_RESTORE, "client.set_parameter('high_c', then['high_c'])\nclient.set_parameter('low_c', then['low_c'])\n")],
        [(_COMPARE + _RESTORE, 'now = ParameterSet.of(client)\nrestore(client, then)\nchanged = compare(then, now)\n')],
        [(_RESTORE, 'client.set_parameters_atomically({name: then[name] for name in ("low_c", "high_c")})\n')],
        [('\n', '\n\n'), ('restore(client, then)', '# and back\nrestore(client, dict(then))')],
        # By its name, as the chapter does.
        [('ParameterSet.of(client)', "ParameterSet.of('/robot', 'then')"),
         (_COMPARE, "changed = compare(then, '/robot')\n"), (_RESTORE, "restore('/robot', then)\n")],
        # Indented, all of them.
        [('\n', '\n    ')],
    ],
    '10.5a': [
        [('all(same_value(*pair) for pair in zip(before, after))', 'all(map(same_value, before, after))')],
        [(_MEND, '    return repr(before) == repr(after)\n')],
        [(_MEND, '''    from param_tools import values
    return values.same(before, after)
''')],
        [(_MEND, '''    from param_tools import compare
    return not compare({'x': before}, {'x': after})
''')],
        [(_MEND, '''    if isinstance(before, list):
        if len(before) != len(after):
            return False
        for position, element in enumerate(before):
            if not same_value(element, after[position]):
                return False
        return True
    if isinstance(before, float) and math.isnan(before):
        return math.isnan(after)
    return before == after
''')],
    ],
    '10.5c': [
        [('return [outcome', 'return sorted([outcome'), ("!= 'set']", "!= 'set'], reverse=True)")],
        [(_BODY, '''    from param_tools import ParameterClient, compare
    client = ParameterClient(node)
    defaults = ParameterSet.defaults(node_class)
    restore(client, {name: defaults[name] for name in defaults if name not in keep})
    return [each.name for each in compare(defaults, client) if each.name not in keep]
''')],
        [(_BODY, '''    from rclpy.parameter import Parameter
    from param_tools import compare
    defaults = ParameterSet.defaults(node_class)
    differing = [each.name for each in compare(node, defaults) if each.name not in keep]
    free = [name for name in differing if not node.describe_parameter(name).read_only]
    result = node.set_parameters_atomically([Parameter(name, value=defaults[name]) for name in free])
    return [name for name in differing if not result.successful or name not in free]
''')],
    ],
}
