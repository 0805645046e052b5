"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.2."""

WRONG = {
    '10.2c': [
        ([('parameter_value_to_python(value)', 'value')], 0, "it gives `{'speed':"),
        ([('zip(names, values)', 'zip(values, names)')],
         0, "AttributeError: 'str' object has no attribute 'type'"),
        ([('zip(names, values)', 'zip(sorted(names), values)')], 1, "it gives `{'label': 0, 'speed': ''}`"),
        ([('zip(names, values)', 'names')], 0, 'ValueError: too many values to unpack (expected 2)'),
        ([('parameter_value_to_python(value)', 'value.integer_value')], 1, "it gives `{'speed': 0, 'label': 0}`"),
        ([('name: param', 'value: param')], 0, "TypeError: unhashable type: 'ParameterValue'"),
        ([('return {', 'return list({'),
          ('values)}', 'values)})')], 0, "it gives `['speed']`"),
        ([('zip(names, values)', 'zip(names, reversed(values))')], 1, "it gives `{'speed': '', 'label': 0}`"),
        ([('parameter_value_to_python(value)',
           'value.double_value or value.integer_value or value.string_value')],
         0, "it gives `{'speed': ''}`"),
    ],
    '10.2a': [
        # What the article promises: no names for all parameters.
        ([('GetParameters.Request(names=names)', 'GetParameters.Request()')], 0, 'it is `{}`'),
        ([('parameter_value_to_python(value)', 'value.string_value or value.integer_value')], 0, "'offset': 0"),
        ([('        if not values and len(names) > 1:', '        if False:')], 2, 'it is `{}`'),
        ([('self.list_client.call_async(ListParameters.Request()).add_done_callback(self.on_names)',
           'self.on_names(self.list_client.call(ListParameters.Request()))')], 0, 'Use call_async()'),
        ([("'/rover/get_parameters'", "'/rover/get_parameter'")], 0,
         'nobody offers a service `/rover/get_parameter`'),
    ],
    '10.2b': [
        ([('if name in parameters', 'if parameters.get(name)')], 2, 'the function gave'),
        ([('if name in parameters', 'if True')], 1, 'KeyError'),
        ([('return {node: parameters[name] for', 'return [node for'), ('in parameters}', 'in parameters]')], 0,
         'the function gave `['),
    ],
}

RIGHT = {
    '10.2c': [
        [('{name: parameter_value_to_python(value) for name, value in zip(names, values)}',
          'dict(zip(names, map(parameter_value_to_python, values)))')],
        [('for name, value in zip(names, values)', 'for value, name in zip(values, names)')],
        [('{name: parameter_value_to_python(value) for name, value in zip(names, values)}',
          '{names[i]: parameter_value_to_python(values[i]) for i in range(len(names))}')],
    ],
}
