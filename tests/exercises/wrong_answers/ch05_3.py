"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.3."""

READ = ('    return {parameter.name: result.reason\n            for parameter, result in zip(parameters, results)\n'
        '            if not result.successful}')
# In the steps: what asks, what sets, and what gives up.
ASK = "self.driver.get_parameters(['max_speed_mps'], callback=self.on_speed)"
SET = "self.driver.set_parameters([Parameter('max_speed_mps', value=limit_mps)], callback=self.on_result)"
_OPEN = '        if self.question and not self.question.done():\n'
GIVE_UP = '        if self.question:\n            self.question.cancel()\n'
_UNHEARD = ASK.replace(', callback=self.on_speed', '')
_CLIENT = "self.driver = AsyncParameterClient(self, 'driver')"
_SLEEPS = 'time.sleep() blocks the thread'

WRONG = {
    '5.3a': [
        ([("'tuner'", "'turner'")], 4, 'it is called `turner`'),
        ([("(self, 'driver')", "(self, 'drver')")], 0, 'there is no service `drver/get_parameters` of that type'),
        ([(ASK, ASK.replace('speed_mps', 'sped_mps'))], 1, 'IndexError: list index out of range'),
        ([(_CLIENT, 'pass')], 0, 'it creates none'),
        ([(f'        {_CLIENT}\n', f'        {_CLIENT}\n        self.driver.wait_for_services()\n')], 3,
         'its constructor did not finish. It was still running after'),
        ([(ASK, _UNHEARD)], 3, 'it logs nothing'),
        ([(ASK, f'future = {_UNHEARD}\n        while not future.done():\n'
           '            pass\n        self.on_speed(future)')], 1, 'did not return'),
        ([(ASK, f"future = {_UNHEARD}\n        __import__('rclpy').spin_until_future_complete(self, future)\n"
           '        self.on_speed(future)')], 1, 'runs inside the executor'),
        ([(ASK, f'self.driver.wait_for_services(1.0) and {ASK}')], 3, _SLEEPS),
        ([(ASK, ASK.replace('on_speed)', 'on_speed())'))], 1, "missing 1 required positional argument: 'future'"),
        ([('        self.create_timer(0.5, self.ask)', '        self.ask()')], 3, 'it is not asked'),
        ([('create_timer(0.5', 'create_timer(1.0')], 3, 'it is asked '),
        ([('def ask(', 'async def ask('), (ASK, f'await {_UNHEARD}')], 1, 'Does the client have a group of its own?'),
        ([('future.result().values[0].double_value', 'future.result().values[0]')], 3,
         'its last line is `max_speed_mps is rcl_'),
        ([('future.result().values[0].double_value', '0.5')], 3, 'its last line is `max_speed_mps is 0.5`'),
        ([('.double_value', '.integer_value')], 3, 'its last line is `max_speed_mps is 0`'),
    ],
    '5.3b': [
        ([("'limit_mps', 0.3", "'limit_mps', 1")], 2, 'type integer, value `1`'),
        ([('value=limit_mps', 'value=0.3')], 6, 'it holds 0.3'),
        ([('speed_mps > limit_mps', 'speed_mps >= limit_mps')], 6, 'the tuner has asked for `max_speed_mps = 0.25`'),
        ([('speed_mps > limit_mps', 'speed_mps != limit_mps')], 6, 'the tuner has asked for `max_speed_mps = 0.3`'),
        ([('speed_mps > limit_mps', 'speed_mps < limit_mps')], 3, 'it holds 0.5'),
        ([(SET, SET.replace(', callback=self.on_result', ''))], 6, 'it logs nothing'),
        ([("f'the driver says: {result.reason}'", "'it says no'")], 6, 'its last line is `it says no`'),
        ([('.results[0]', '.result')], 1, "'SetParameters_Response' object has no attribute 'result'"),
        # No deadline: it asks and says nothing, or it waits for good.
        ([(GIVE_UP, '')], 6, 'it logs nothing'),
        ([(GIVE_UP, f'{_OPEN}            return\n')], 6, 'it logs nothing'),
        ([(GIVE_UP, f"{_OPEN}            self.get_logger().warning('no')\n            return\n")], 6, 'it is not'),
        ([(GIVE_UP, f'        self.driver.wait_for_services()\n{GIVE_UP}')], 4, _SLEEPS),
        ([('        rclpy.spin(Tuner())', '        tuner = Tuner()')], 5, 'Nothing spins the node'),
        ([("driver_node:main',", "driver_node:main'")], 6, 'Is there a comma between it and the other line?'),
        ([("            'driver_node = my_robot.driver_node:main',\n", '')], 6, 'there is no such line'),
    ],
    '5.3c': [
        ([('parameter.name: result.reason', 'result.name: result.reason')], 0, 'A result has no name'),
        ([(READ, '    for parameter, result in zip(parameters, results):\n'
           '        if not result.successful:\n            return {parameter.name: result.reason}\n    return {}')], 2,
         'before the loop has ended'),
        ([('successful}', 'successful} or None')], 2, 'the function returned `None`'),
        ([('            if not result.successful', '            if True')], 0, "'use_sim_time': ''"),
        ([('if not result.successful', 'if result.successful')], 0,
         "returned `{'max_speed_mps': '', 'use_sim_time': ''}`"),
        ([(READ, '    for parameter, result in zip(parameters, results):\n        reasons = {}\n'
           '        if not result.successful:\n            reasons[parameter.name] = result.reason\n'
           '    return reasons')], 1,
          'the function returned `{}`'),
        ([('if not result.successful', 'if result.reason')], 2, 'A node may reject without a reason'),
        ([(READ, '    return {parameters[results.index(result)].name: result.reason\n'
           '            for result in results\n            if not result.successful}')], 2, 'Two results may be equal'),
        ([(': result.reason', ': result')], 1, 'SetParametersResult(successful=False'),
        ([('parameter.name: result.reason', 'result.reason: parameter.name')], 1,
         "5.0, value: 9.0': 'stop_distance_m"),
        ([('zip(parameters, results)', 'zip(sorted(parameters, key=lambda each: each.name), results)')], 2,
         'the function returned `{'),
        ([('    return {', '    print({'), ('successful}', 'successful})')], 0, 'the function returned `None`'),
        ([('    return {', '    return [('), ('result.reason\n', 'result.reason)\n'),
          ('parameter.name:', 'parameter.name,'), ('successful}', 'successful]')], 0, 'the function returned `[('),
        ([(READ, "    return {'stop_distance_m': results[1].reason}")], 0,
         "returned `{'stop_distance_m': ''}`"),
        ([('def rejected(parameters, results)', 'def rejected(results)')], 0, 'takes 1 positional argument'),
        ([('parameters, results):', 'parameters, results, found={}):'),
          (READ, f'    found.update({READ.strip().removeprefix("return ")})\n    return found')],
         0, 'from an earlier call'),
        ([(READ, READ.replace('return {', 'yield {'))], 0, 'the function returned `<generator'),
        ([('zip(parameters, results)', 'list(zip(parameters, results))[:4]')], 2, 'the function returned'),
    ],
}

RIGHT = {
    '5.3a': [
        # The services one by one, and by their full names.
        [(_CLIENT, "self.client = self.create_client(__import__('rcl_interfaces.srv').srv.GetParameters, "
                   "'/driver/get_parameters')"),
         (ASK, "self.client.call_async(self.client.srv_type.Request(names=['max_speed_mps'])).add_done_callback("
               'self.on_speed)')],
        [("(self, 'driver')", "(self, '/driver')")],
        [('self.ask)', 'self.ask, __import__("rclpy.callback_groups").callback_groups.ReentrantCallbackGroup())'),
         ('    def ask', '    async def ask'), (ASK, f'self.on_speed(await {_UNHEARD})'),
         ('future.result()', 'future')],
        [(ASK, f'if self.driver.services_are_ready():\n            {ASK}')],
        [('.info(', '.warning(')],
    ],
    '5.3b': [
        # The driver is looked for, and a question that is late is left to itself.
        [(GIVE_UP, '        if not self.driver.services_are_ready():\n'
                   "            self.get_logger().error('no driver')\n            return\n"
                   f"{_OPEN}            self.get_logger().warning('no answer')\n")],
        # A timer of the question's own.
        [(GIVE_UP, ''), (f'        self.question = {ASK}',
          f'        future = {ASK}\n        timer = self.create_timer(0.4, lambda: self.give_up(future, timer))'),
         ('    def on_speed', '    def give_up(self, future, timer):\n        self.destroy_timer(timer)\n'
                              '        future.cancel()\n\n    def on_speed')],
        [('set_parameters([Parameter', 'set_parameters_atomically([Parameter'), ('.results[0]', '.result')],
        [("(self, 'driver')", "(self, '/driver')"), ('create_timer(0.5', 'create_timer(0.4')],
    ],
    '5.3c': [
        [(READ, '    reasons = {}\n    for index, result in enumerate(results):\n        if not result.successful:\n'
                '            reasons[parameters[index].name] = result.reason\n    return reasons')],
        [(READ, '    pairs = filter(lambda pair: not pair[1].successful, zip(parameters, results))\n'
                '    return dict((parameter.name, result.reason) for parameter, result in pairs)')],
        [(READ, '    reasons = {}\n    for parameter in parameters:\n        result = results.pop(0)\n'
                '        if result.successful:\n            continue\n'
                '        reasons[parameter.name] = result.reason\n    return reasons')],
        # An object that is called like a function.
        [('def rejected(parameters, results):', 'def reasons(no_reason, parameters, results):'),
         (': result.reason', ': result.reason or no_reason'),
         ('not result.successful}',
          "not result.successful}\n\nimport functools\nrejected = functools.partial(reasons, '')")],
    ],
}
