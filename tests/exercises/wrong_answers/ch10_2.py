"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.2."""

# In the solutions: what the inspector does, with a deadline for each question.
IN_TIME = '''\
        answer = await self.in_time(self.list_client.call_async(ListParameters.Request()))
        for name in answer.result.names if answer else []:
            answer = await self.in_time(self.get_client.call_async(GetParameters.Request(names=[name])))
            if answer and answer.values:
                self.found[name] = parameter_value_to_python(answer.values[0])

    async def in_time(self, future):
        """Return the answer, or None if there is none after five seconds."""
        deadline = self.create_timer(5.0, future.cancel)
        answer = await future
        self.destroy_timer(deadline)
        return answer'''
# The same without deadlines, as most people write it, and as all answers to 10.2b below begin.
READ = '''\
        answer = await self.list_client.call_async(ListParameters.Request())
        for name in answer.result.names:
            values = (await self.get_client.call_async(GetParameters.Request(names=[name]))).values
            if values:
                self.found[name] = parameter_value_to_python(values[0])'''

WRONG = {
    '10.2a': [
        ([('parameter_value_to_python(value)', 'value')], 0, "it returned `{'speed':"),
        ([('zip(names, values)', 'zip(sorted(names), values)')], 1, "it returned `{'label': 0, 'speed': ''}`"),
        ([('zip(names, values)', 'zip(values, names)')],
         0, "AttributeError: 'str' object has no attribute 'type'"),
        ([('zip(names, values)', 'names')], 0, 'ValueError: too many values to unpack (expected 2)'),
        ([('parameter_value_to_python(value)', 'value.integer_value')], 1, "it returned `{'speed': 0, 'label': 0}`"),
        ([('name: param', 'value: param')], 0, "TypeError: unhashable type: 'ParameterValue'"),
        ([('return {', 'return list({'),
          ('values)}', 'values)})')], 0, "it returned `['speed']`"),
        ([('zip(names, values)', 'zip(names, reversed(values))')], 1, "it returned `{'speed': '', 'label': 0}`"),
        ([('parameter_value_to_python(value)',
           'value.double_value or value.integer_value or value.string_value')],
         0, "it returned `{'speed': ''}`"),
    ],
    '10.2b': [
        # What the article promises: no names for all parameters.
        ([(READ, '        self.get_client.call_async(GetParameters.Request()).add_done_callback(self.on_values)\n\n'
                 '    def on_values(self, future):\n        for value in future.result().values:\n'
                 '            self.found[value.name] = parameter_value_to_python(value)')], 0, 'it is `{}`'),
        ([('answer = await self.list_client', 'answer = self.list_client')], 0, 'It is a future'),
        # All questions at once: the client keeps ten answers, and loses others if the rover is in another process.
        ([('        for name in answer.result.names:\n            values = (await self.get_client.call_async('
           'GetParameters.Request(names=[name]))).values\n',
           '        futures = [(name, self.get_client.call_async(GetParameters.Request(names=[name])))\n'
           '                   for name in answer.result.names]\n'
           '        for name, future in futures:\n            values = (await future).values\n')], 2,
         '36 were, and the client keeps the last 10 answers'),
        # Waits for a rover that is not there.
        ([(READ, f'        while not self.list_client.wait_for_service(timeout_sec=1.0):\n            pass\n{READ}')],
         2, 'as wait_for_service() does'),
        ([(READ, f'        self.list_client.wait_for_service()\n        self.get_client.wait_for_service()\n{READ}')],
         2, 'as wait_for_service() does'),
        ([(READ, f'        import time\n        time.sleep(0.2)\n{READ}')], 2, 'time.sleep() blocks the thread'),
        # All at once: one that is not set empties the answer.
        ([(READ, '        names = (await self.list_client.call_async(ListParameters.Request())).result.names\n'
                 '        values = (await self.get_client.call_async(GetParameters.Request(names=names))).values\n'
                 '        self.found = dict(zip(names, map(parameter_value_to_python, values)))')], 2, 'it is `{}`'),
        ([(READ, "        for name in ('speed', 'offset', 'label', 'enabled', 'gains', 'legs', 'steps'):\n"
                 '            values = (await self.get_client.call_async(GetParameters.Request(names=[name]))).values\n'
                 '            if values:\n                self.found[name] = parameter_value_to_python(values[0])')], 0,
         "it is `{'speed': 0"),
        ([('parameter_value_to_python(values[0])', 'values[0].string_value or values[0].integer_value')], 0,
         "'offset': 0"),
        ([('parameter_value_to_python(values[0])', 'str(parameter_value_to_python(values[0]))')], 0, "'speed': '0'"),
        ([('parameter_value_to_python(values[0])', 'values[0]')], 0, 'ParameterValue(type='),
        ([('            if values:', '            if True:')], 2, 'IndexError'),
        ([('parameter_value_to_python(values[0])', 'parameter_value_to_python(values[0])\n'
           '            else:\n                self.found[name] = 0.0')], 2, "'calibration': 0.0"),
        ([('if values:', 'if values and parameter_value_to_python(values[0]):')], 0, "it is `{'gains'"),
        ([('ListParameters.Request()', 'ListParameters.Request(depth=1)')], 1, 'it is `{'),
        ([('self.found[name] = parameter_value_to_python(values[0])', 'self.found = {name: values[0]}')], 0,
         'it is `{'),
        ([('self.found[name]', 'self.values[name]')], 0, "object has no attribute 'values'"),
        ([('await self.list_client.call_async(', 'self.list_client.call(')], 0,
          'Use call_async()'),
        ([('answer = await ', 'answer = ')], 0, "'function' object has no attribute 'names'"),
        ([('async def inspect(self):', 'def inspect(self):'),
          ('answer = await self', 'import rclpy\n        future = self'),
          ('        for name in answer', '        rclpy.spin_until_future_complete(self, future)\n'
           '        answer = future.result()\n        for name in answer'),
          ('(await self.get_client.call_async(', 'self.get_client.call('),
          ('(names=[name]))).values', '(names=[name])).values')],
         0, 'this callback already runs inside the executor that it waits for'),
        ([("'/rover/get_parameters'", "'/rover/get_parameter'")], 0,
         'there is no service `/rover/get_parameter` of that type'),
        ([("GetParameters, '/rover/get", "ListParameters, '/rover/get")], 0,
         'the service `/rover/get_parameters` is of another type than the client'),
        ([('def inspect', 'def look')], 0, 'the class has none'),
        # The answer waits for the callback group of the timer, and the timer for the answer.
        ([('async def inspect(self):\n',
           'def inspect(self):\n        self.timer = self.create_timer(0.3, self.work)\n\n'
           '    async def work(self):\n        self.timer.cancel()\n')], 0, 'and 1 of 1 questions have no answer'),
    ],
    '10.2c': [
        ([("['max_acceleration_mps2'])", "['max_acceleration'])")], 0, 'it holds 0.3'),
        ([('math.sqrt(2 * base', 'math.sqrt(base')], 0, 'it holds 0.17'),
        ([("['max_speed_mps'] > safe_mps", "['max_speed_mps'] < safe_mps")], 0, 'it holds 0.3'),
        ([("['max_speed_mps'] > safe_mps", "['max_speed_mps'] != safe_mps")], 2, 'the driver was asked for 0.25'),
        ([(', callback_group=MutuallyExclusiveCallbackGroup()', '')], 0, 'it holds 0.3'),
        ([("['max_speed_mps', 'stop_distance_m'])", "['stop_distance_m', 'max_speed_mps'])"),
          ('zip(names, values)', "zip(['max_speed_mps', 'stop_distance_m', 'max_acceleration_mps2'], values)")], 0,
         "KeyError: 'max_acceleration_mps2'"),
        ([("warning('no answer from the base", "debug('no answer from the base")], 2, 'there is none'),
        ([('self.create_timer(0.5, question.cancel)', 'self.create_timer(600.0, question.cancel)')], 2,
         'there is none'),
        ([('        question = client', '        client.wait_for_services()\n        question = client')], 2,
         'time.sleep() blocks the thread'),
    ],
}

RIGHT = {
    '10.2a': [
        [('{name: parameter_value_to_python(value) for name, value in zip(names, values)}',
          'dict(zip(names, map(parameter_value_to_python, values)))')],
        [('for name, value in zip(names, values)', 'for value, name in zip(values, names)')],
        [('{name: parameter_value_to_python(value) for name, value in zip(names, values)}',
          '{names[i]: parameter_value_to_python(values[i]) for i in range(len(names))}')],
    ],
    '10.2b': [
        # With callbacks, and only then one by one: each question waits for the answer before.
        [('async def inspect(self):', 'def inspect(self):'),
         (READ, '        self.list_client.call_async(ListParameters.Request()).add_done_callback(self.on_names)\n\n'
                '    def on_names(self, future):\n        self.ask(list(future.result().result.names))\n\n'
                '    def ask(self, names):\n'
                '        future = self.get_client.call_async(GetParameters.Request(names=names))\n'
                '        future.add_done_callback(lambda future: self.on_values(names, future.result().values))\n\n'
                '    def on_values(self, names, values):\n        if not values and len(names) > 1:\n'
                '            self.rest = list(names)\n'
                '        for name, value in zip(names, values):\n'
                '            self.found[name] = parameter_value_to_python(value)\n'
                '        if getattr(self, "rest", []):\n            self.ask([self.rest.pop()])')],
        # All questions at once, through a client that keeps as many answers.
        [("'/rover/get_parameters')", "'/rover/get_parameters',\n            "
          "qos_profile=__import__('rclpy').qos.QoSProfile(depth=1000))"),
         ('        for name in answer.result.names:\n            values = (await self.get_client.call_async('
          'GetParameters.Request(names=[name]))).values\n',
          '        futures = [(name, self.get_client.call_async(GetParameters.Request(names=[name])))\n'
          '                   for name in answer.result.names]\n'
          '        for name, future in futures:\n            values = (await future).values\n')],
        # rclpy's own client.
        [("        self.list_client = self.create_client(ListParameters, '/rover/list_parameters')\n"
          "        self.get_client = self.create_client(GetParameters, '/rover/get_parameters')\n",
          '        from rclpy.parameter_client import AsyncParameterClient\n'
          "        self.box = AsyncParameterClient(self, '/rover')\n"),
         ('self.list_client.call_async(ListParameters.Request())', 'self.box.list_parameters()'),
         ('self.get_client.call_async(GetParameters.Request(names=[name]))', 'self.box.get_parameters([name])')],
        # In a thread of its own, which may block.
        [('async def inspect(self):\n        """Ask /rover for all its parameters, without blocking."""\n',
          'def inspect(self):\n        import threading\n'
          '        threading.Thread(target=self.work, daemon=True).start()\n\n    def work(self):\n'),
         ('await self.list_client.call_async(', 'self.list_client.call('),
         ('(await self.get_client.call_async(GetParameters.Request(names=[name])))',
          'self.get_client.call(GetParameters.Request(names=[name]))')],
        # What is not set is there with None.
        [('parameter_value_to_python(values[0])', 'parameter_value_to_python(values[0])\n'
          '            else:\n                self.found[name] = None')],
        [(READ, f'        if not self.list_client.service_is_ready():\n            return\n{READ}')],
        # Later, by a timer with a callback group of its own.
        [('async def inspect(self):\n',
          'def inspect(self):\n        from rclpy.callback_groups import ReentrantCallbackGroup\n'
          '        self.timer = self.create_timer(0.3, self.work, callback_group=ReentrantCallbackGroup())\n\n'
          '    async def work(self):\n        self.timer.cancel()\n')],
    ],
    '10.2c': [
        [('if not base or not driver:', 'if not (base and driver):')],
        [("math.sqrt(2 * base['max_acceleration_mps2'] * driver['stop_distance_m'])",
          "(base['max_acceleration_mps2'] * 2 * driver['stop_distance_m']) ** 0.5")],
    ],
}

WRONG['10.2b'] = [([(IN_TIME, READ), *replacements], count, word) for replacements, count, word in WRONG['10.2b']]
RIGHT['10.2b'] = [[(IN_TIME, READ)], *([(IN_TIME, READ), *replacements] for replacements in RIGHT['10.2b'])]
