"""Wrong answers that people give to the exercises of chapter 10.2."""

WRONG = {
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
