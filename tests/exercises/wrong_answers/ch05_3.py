"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.3."""

WRONG = {
    '5.3c': [
        ([("parameter = Parameter('max_speed_rpm', value=50)\n", ''),
          ('request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n',
           'request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n'
           "parameter = Parameter('max_speed_rpm', value=50)\n")],
         0, "NameError: name 'parameter' is not defined, in the line"),
        ([("client = node.create_client(SetParameters, '/rover/set_parameters')\n", ''),
          ('future = client.call_async(request)\n',
           'future = client.call_async(request)\n'
           "client = node.create_client(SetParameters, '/rover/set_parameters')\n")],
         0, "NameError: name 'client' is not defined, in the line"),
        ([('request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n', ''),
          ('future = client.call_async(request)\n',
           'future = client.call_async(request)\n'
           'request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n')],
         0, "NameError: name 'request' is not defined, in the line"),
        ([('future.add_done_callback(lambda answer: results.extend(answer.result().results))\n', ''),
          ("client = node.create_client(SetParameters, '/rover/set_parameters')\n",
           'future.add_done_callback(lambda answer: results.extend(answer.result().results))\n'
           "client = node.create_client(SetParameters, '/rover/set_parameters')\n")],
         0, "NameError: name 'future' is not defined, in the line"),
        ([('future.add_done_callback(lambda answer: results.extend(answer.result().results))\n', '')],
         1, '`results` is empty'),
        ([('future = client.call_async(request)\n'
           'future.add_done_callback(lambda answer: results.extend(answer.result().results))\n',
           '')], 0, 'it holds 100'),
        ([('.to_parameter_msg()', '')], 0, "AttributeError: 'int' object has no attribute 'type', in"),
        ([('value=50', 'value=50.0')], 0, 'it holds 100'),
        ([('/rover/', '/rovr/')], 0, 'nobody offers a service `/rovr/set_parameters`'),
        ([('results.extend(answer.result().results)', 'answer')], 1, '`results` is empty'),
    ],
    '5.3a': [
        # Not atomic: the other service, whose answer has a list of results.
        ([('SetParametersAtomically', 'SetParameters'), ('set_parameters_atomically', 'set_parameters'),
          ('class Supervisor', 'from rcl_interfaces.srv import SetParameters\n\n\nclass Supervisor'),
          ('future.result().result', 'future.result().results[1]')], 2,
         '`set_parameters` decides each parameter for itself'),
        ([("'/rover/set_parameters_atomically'", "'/rovr/set_parameters_atomically'")], 0,
         'nobody offers a service `/rovr/set_parameters_atomically`'),
        ([('self.client.call_async(request).add_done_callback(self.on_answer)', 'self.client.call(request)')], 0,
         'Use call_async()'),
        ([('.add_done_callback(self.on_answer)', '')], 1, "`self.rejection` is `''`"),
        ([('future.result().result\n', 'future.result().results[0]\n')], 1, 'AttributeError'),
        ([('value=40', 'value=4')], 1, 'it holds 4 and 0.2'),
    ],
    '5.3b': [
        ([('parameter.name: result.reason', 'result.name: result.reason')], 1, 'A result has no name'),
        ([('            if not result.successful', '            if True')], 0, "'use_sim_time': ''"),
        ([('    return {parameter.name: result.reason\n            for parameter, result in zip(parameters, results)\n'
           '            if not result.successful}', '    for parameter, result in zip(parameters, results):\n'
           '        if not result.successful:\n            return {parameter.name: result.reason}\n    return {}')], 2,
         'before the loop has ended'),
    ],
}

RIGHT = {
    '5.3c': [
        [("client = node.create_client(SetParameters, '/rover/set_parameters')\n", ''),
         ('future = client.call_async(request)\n',
          "client = node.create_client(SetParameters, '/rover/set_parameters')\n"
          'future = client.call_async(request)\n')],
        [("client = node.create_client(SetParameters, '/rover/set_parameters')\n", ''),
         ("parameter = Parameter('max_speed_rpm', value=50)\n",
          "parameter = Parameter('max_speed_rpm', value=50)\n"
          "client = node.create_client(SetParameters, '/rover/set_parameters')\n")],
        [('future = client.call_async(request)\n'
          'future.add_done_callback(lambda answer: results.extend(answer.result().results))\n',
          'results.extend(client.call(request).results)\n')],
        [("'/rover/set", "'rover/set")],
    ],
}
