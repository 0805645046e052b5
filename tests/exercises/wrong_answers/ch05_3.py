"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.3."""

# In the solutions: the line that sends the request, and the one that reads the answer.
ASK = 'self.client.call_async(request).add_done_callback(self.on_answer)'
AWAIT = ('result = (await self.client.call_async(request)).result\n'
         '        self.rejection = result.reason')
CLIENT = "self.client = self.create_client(SetParametersAtomically, '/rover/set_parameters_atomically')"
READ = ('    return {parameter.name: result.reason\n            for parameter, result in zip(parameters, results)\n'
        '            if not result.successful}')

_SLOW = 'again and again an answer takes '


def in_group(group: str) -> str:
    """Return the line that creates the client, in a callback group."""
    return CLIENT.replace("atomically')", f"atomically', callback_group={group})")


WRONG = {
    '5.3a': [
        ([("parameter = Parameter('max_speed_rpm', value=50)\n", ''),
          ('request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n',
           'request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])\n'
           "parameter = Parameter('max_speed_rpm', value=50)\n")],
         0, "NameError: name 'parameter' is not defined, in the line"),
        ([('future.add_done_callback(lambda answer: results.extend(answer.result().results))\n', '')],
         1, '`results` is empty'),
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
        ([('future = client.call_async(request)\n'
           'future.add_done_callback(lambda answer: results.extend(answer.result().results))\n',
           '')], 0, 'it holds 100'),
        ([('.to_parameter_msg()', '')], 0, "AttributeError: 'int' object has no attribute 'type', in"),
        ([('/rover/', '/rovr/')], 0, 'there is no service `/rovr/set_parameters` of that type'),
        # A line twice: the first request gets no answer that anybody reads.
        ([('future = client.call_async(request)\n',
           'future = client.call_async(request)\nfuture = client.call_async(request)\n')], 0, 'it is asked 2 times'),
    ],
    '5.3b': [
        ([("'/rover/set_parameters_atomically'", "'/rover/set_parameters'")], 0,
         'the service `/rover/set_parameters` is of another type than the client'),
        ([('.add_done_callback(self.on_answer)', '')], 2, "it is `''`"),
        # Not atomic: the other service, whose answer has a list of results.
        ([('SetParametersAtomically', 'SetParameters'), ('set_parameters_atomically', 'set_parameters'),
          ('class Supervisor', 'from rcl_interfaces.srv import SetParameters\n\n\nclass Supervisor'),
          ('result = future.result().result\n',
           'result = min(future.result().results, key=lambda each: each.successful)\n')],
         2, '`set_parameters` decides about each parameter separately'),
        ([("'/rover/set_parameters_atomically'", "'/rovr/set_parameters_atomically'")], 0,
         'there is no service `/rovr/set_parameters_atomically` of that type'),
        ([("'/rover/set_parameters_atomically'", "'/supervisor/set_parameters_atomically'")], 0,
         'there is no service `/supervisor/set_parameters_atomically` of that type'),
        ([("self.client = self.create_client(SetParametersAtomically, '/rover/set_parameters_atomically')", 'pass')], 0,
         'it creates none'),
        # Hangs under rclpy.spin: the timer and the client are in one group.
        ([('def slow_down', 'async def slow_down'), (ASK, AWAIT)], 0, 'Does the client have a group of its own?'),
        # Blocked: for good, for a while, and in loops.
        ([(ASK, 'self.client.call(request)')], 0, 'Use call_async()'),
        ([(ASK, 'import rclpy\n        future = self.client.call_async(request)\n'
           '        rclpy.spin_until_future_complete(self, future)\n        self.on_answer(future)')],
         0, 'this callback already runs inside the executor that it waits for'),
        ([(ASK, 'future = self.client.call_async(request)\n        while not future.done():\n            pass\n'
           '        self.on_answer(future)')], 0, 'it was still running after some seconds'),
        ([(ASK, f'import time\n        time.sleep(0.5)\n        {ASK}')], 0, 'time.sleep() blocks the thread'),
        # Waits for a rover that is not there: for good, for a while, in a loop, in the constructor, or dies of it.
        ([(ASK, f'while not self.client.wait_for_service(timeout_sec=1.0):\n            pass\n        {ASK}')], 2,
         'So does whatever sleeps inside, as wait_for_service() does'),
        ([(ASK, f'self.client.wait_for_service()\n        {ASK}')], 2, 'as wait_for_service() does'),
        ([(ASK, f'if not self.client.wait_for_service(timeout_sec=0.1):\n            return\n        {ASK}')], 2,
         'as wait_for_service() does'),
        ([(ASK, f'while not self.client.service_is_ready():\n            pass\n        {ASK}')], 2,
         'it was still running after some seconds'),
        ([(f'{CLIENT}\n', f'{CLIENT}\n        self.client.wait_for_service()\n')], 2, 'it was still running after'),
        ([(ASK, f'if not self.client.service_is_ready():\n            raise RuntimeError("no rover")\n        {ASK}')],
         2, 'RuntimeError: no rover'),
        ([('value=0.2)]', "value=0.2), Parameter('use_sim_time', value=False)]")], 2,
         'it is asked for `use_sim_time` too'),
        # Too early: the answer has not come.
        ([(ASK, 'self.on_answer(self.client.call_async(request))')], 0,
         "AttributeError: 'NoneType' object has no attribute 'result'"),
        ([(ASK, 'self.client.call_async(request).add_done_callback(self.on_answer())')], 0,
         "missing 1 required positional argument: 'future'"),
        ([('future.result().result\n', 'future.result().results[0]\n')], 1, 'AttributeError'),
        ([('self.rejection = result.reason', 'self.rejection = str(result)')], 2, 'rcl_interfaces.msg'),
        ([('self.rejection = result.reason', "self.rejection = 'rejected'")], 2, "it is `'rejected'`"),
        ([('if not result.successful:', 'if True:'), ('= result.reason', "= result.reason or 'accepted'")], 2,
         "it is `'accepted'`"),
        ([('value=40', 'value=4')], 0, 'it holds 4 and 0.2'),
        ([('value=40', 'value=40.0')], 0, "`self.rejection` is `\"Wrong parameter type, expected 'Type.INTEGER'"),
        ([('value=0.2', 'value=20.0')], 0, 'it holds 100 and 1.0, and `self.rejection` is'),
        ([(ASK, 'self.set_parameters_atomically(wanted)')], 0, 'ParameterNotDeclaredException'),
        ([('def slow_down', 'def slowdown')], 0, 'the class has none'),
        ([("super().__init__('supervisor')", "super().__init__('boss')")], 3, 'it is called `boss`'),
        ([("/rover/set_parameters_atomically')\n",
           "/rover/set_parameters_atomically')\n        self.slow_down()\n")], 0, 'the constructor has sent one'),
    ],
    '5.3c': [
        ([('parameter.name: result.reason', 'result.name: result.reason')], 0, 'A result has no name'),
        ([(READ, '    for parameter, result in zip(parameters, results):\n'
           '        if not result.successful:\n            return {parameter.name: result.reason}\n    return {}')], 2,
         'before the loop has ended'),
        ([('successful}', 'successful} or None')], 2, 'the function returned `None`'),
        ([('            if not result.successful', '            if True')], 0, "'use_sim_time': ''"),
        ([('if not result.successful', 'if result.successful')], 0,
         "returned `{'max_speed_rpm': '', 'use_sim_time': ''}`"),
        ([(READ, '    for parameter, result in zip(parameters, results):\n        reasons = {}\n'
           '        if not result.successful:\n            reasons[parameter.name] = result.reason\n'
           '    return reasons')], 1,
          'the function returned `{}`'),
        ([('if not result.successful', 'if result.reason')], 2, 'A node may reject without a reason'),
        ([(READ, '    return {parameters[results.index(result)].name: result.reason\n'
           '            for result in results\n            if not result.successful}')], 2, 'Two results may be equal'),
        ([(': result.reason', ': result')], 1, 'SetParametersResult(successful=False'),
        ([('parameter.name: result.reason', 'result.reason: parameter.name')], 1,
         "2.0, value: 9.0': 'max_acceleration"),
        ([('zip(parameters, results)', 'zip(sorted(parameters, key=lambda each: each.name), results)')], 1,
         "the function returned `{'max_speed_rpm': 'Parameter max_acceleration"),
        ([('    return {', '    print({'), ('successful}', 'successful})')], 0, 'the function returned `None`'),
        ([('    return {', '    return [('), ('result.reason\n', 'result.reason)\n'),
          ('parameter.name:', 'parameter.name,'), ('successful}', 'successful]')], 0, 'the function returned `[('),
        ([(READ, "    return {'max_acceleration_mps2': results[1].reason}")], 0,
         "returned `{'max_acceleration_mps2': ''}`"),
        ([('def rejected(parameters, results)', 'def rejected(results)')], 0, 'takes 1 positional argument'),
        ([('parameters, results):', 'parameters, results, found={}):'),
          (READ, f'    found.update({READ.strip().removeprefix("return ")})\n    return found')],
         0, 'from an earlier call'),
        ([(READ, READ.replace('return {', 'yield {'))], 0, 'the function returned `<generator'),
        ([('zip(parameters, results)', 'list(zip(parameters, results))[:4]')], 2, 'the function returned'),
    ],
    '5.3d': [
        ([('        self.create_timer(0.5, self.ask)', '        self.getter.wait_for_service()\n        '
           'self.create_timer(0.5, self.ask)')], 0, 'Does a callback wait, or loop forever?'),
        # Waits in the timer: for a while, for the shortest one, and for whatever reason.
        ([('self.getter.service_is_ready() and', 'self.getter.wait_for_service(timeout_sec=1.0) and')], 7, _SLOW),
        ([('self.getter.service_is_ready() and', 'self.getter.wait_for_service(timeout_sec=0.1) and')], 7, _SLOW),
        ([('    def ask(self):\n', "    def ask(self):\n        __import__('time').sleep(0.3)\n")], 7, _SLOW),
        # Seldom, and at the limit, too.
        ([('create_timer(0.5', 'create_timer(1.0')], 7, 'it has been asked '),
        ([('integer_value > limit_rpm', 'integer_value >= limit_rpm')], 7, 'the guard has set `max_speed_rpm` to 50'),
        ([('integer_value > limit_rpm', 'integer_value < limit_rpm')], 4, 'it holds 100'),
        ([('limit_rpm = self.get_parameter(', 'limit_rpm = 60 or self.get_parameter(')], 7, 'it holds 60, after'),
        ([('integer_value > limit_rpm', 'integer_value != limit_rpm')], 7, 'the guard has set `max_speed_rpm` to 60'),
        ([("self.get_logger().info(f'the rover says: {result.reason}')", 'pass')], 7, 'it prints nothing'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'KeyboardInterrupt')], 7, 'That is what SIGTERM raises'),
        ([('future.add_done_callback(self.on_speed)', 'rclpy.spin_until_future_complete(self, future)\n            '
           'self.on_speed(future)')], 2, 'Does a callback wait, or loop forever?'),
        ([('parameter.to_parameter_msg()', 'parameter')], 2, 'it ended with `'),
    ],
}

RIGHT = {
    '5.3a': [
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
        # Indented, like a block of a function.
        [('results))\n"""', 'results))\n""".replace("\\n", "\\n    ")')],
    ],
    '5.3b': [
        # With await, and a client that is free to bring the answer.
        [('def slow_down', 'async def slow_down'), (ASK, AWAIT),
         (CLIENT, 'from rclpy.callback_groups import MutuallyExclusiveCallbackGroup as Group\n'
                  f'        {in_group("Group()")}')],
        [('def slow_down', 'async def slow_down'), (ASK, AWAIT),
         (CLIENT, 'from rclpy.callback_groups import ReentrantCallbackGroup as Group\n'
                  f'        {in_group("Group()")}')],
        # rclpy's own client.
        [("self.client = self.create_client(SetParametersAtomically, '/rover/set_parameters_atomically')",
          'from rclpy.parameter_client import AsyncParameterClient\n'
          "        self.box = AsyncParameterClient(self, '/rover')"),
         (ASK, 'self.box.set_parameters_atomically(wanted, callback=self.on_answer)')],
        # In a thread of its own, which may block.
        [(ASK, 'import threading\n        threading.Thread(target=self.ask, args=[request], daemon=True).start()'),
         ('    def on_answer', '    def ask(self, request):\n        result = self.client.call(request).result\n'
                             '        self.rejection = result.reason\n\n    def on_answer')],
        # A timer looks for the answer.
        [(ASK, 'self.future = self.client.call_async(request)\n'
               '        self.timer = self.create_timer(0.05, self.look)'),
         ('    def on_answer', '    def look(self):\n        if self.future.done():\n            self.timer.cancel()\n'
                             '            self.on_answer(self.future)\n\n    def on_answer')],
        # It looks whether the rover is there, and waits for it without keeping the thread.
        [(ASK, f'if self.client.service_is_ready():\n            {ASK}')],
        [(ASK, f'if not self.client.wait_for_service(timeout_sec=0.0):\n            return\n        {ASK}')],
        [(ASK, f'if not self.client.service_is_ready():\n            self.get_logger().warning("no rover")\n'
               f'            return\n        {ASK}')],
        [('        wanted = [', '        if not self.client.service_is_ready():\n            self.later = '
          'self.create_timer(0.1, self.again)\n            return\n        wanted = ['),
         ('    def on_answer', '    def again(self):\n        self.later.cancel()\n        self.slow_down()\n\n'
          '    def on_answer')],
        [(f'{CLIENT}\n', f'{CLIENT}\n        self.client.wait_for_service(timeout_sec=0.3)\n')],
        # It asks only when nothing seems to be on its way: a timer is, and so is a thread.
        [(ASK, 'self.timer = self.create_timer(0.8, lambda: self.ask(request))'),
         ('    def on_answer', '    def ask(self, request):\n        self.timer.cancel()\n'
                             '        self.client.call_async(request).add_done_callback(self.on_answer)\n\n'
                             '    def on_answer')],
        [(ASK, 'import threading\n        threading.Timer(0.8, self.ask, [request]).start()'),
         ('    def on_answer', '    def ask(self, request):\n'
                             '        self.client.call_async(request).add_done_callback(self.on_answer)\n\n'
                             '    def on_answer')],
        [('self.on_answer)', "lambda future: setattr(self, 'rejection', future.result().result.reason))")],
        [('def on_answer', 'async def on_answer')],
        [("'max_speed_rpm', value", "'max_speed_rpm', Parameter.Type.INTEGER, value")],
        [("'/rover/set", "'rover/set")],
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
    '5.3d': [
        # It waits, with `await`, in a callback group of its own.
        [('self.create_timer(0.5, self.ask)', 'self.create_timer(0.5, self.ask, MutuallyExclusiveCallbackGroup())'),
         ('import Node\n', 'import Node\nfrom rclpy.callback_groups import MutuallyExclusiveCallbackGroup\n'),
         ('    def ask', '    async def ask'),
         ('            future.add_done_callback(self.on_speed)', '            await future\n            '
          'self.on_speed(future)')],
        [('SetParameters.Request', 'SetParametersAtomically.Request'), ('SetParameters, ', 'SetParametersAtomically, '),
         ('GetParameters, SetParameters\n', 'GetParameters, SetParametersAtomically\n'),
         ("'/rover/set_parameters'", "'/rover/set_parameters_atomically'"), ('.results[0]', '.result')],
        # It looks without waiting.
        [('self.getter.service_is_ready() and', 'self.getter.wait_for_service(timeout_sec=0.0) and')],
        # Not while an answer is on its way, and a bit more often.
        [('        if self.getter.service_is_ready() and', "        if getattr(self, 'open', None) and not self.open."
          'done():\n            return\n        if self.getter.service_is_ready() and'),
         ('            future =', '            self.open = future ='), ('create_timer(0.5', 'create_timer(0.4')],
        # The client that rclpy brings.
        [('self.setter.call_async(request)', "AsyncParameterClient(self, '/rover').set_parameters([parameter])"),
         ('import Parameter\n', 'import Parameter\nfrom rclpy.parameter_client import AsyncParameterClient\n')],
        [("'/rover/get_parameters'", "'rover/get_parameters'"), ("'/rover/set_parameters'", "'rover/set_parameters'"),
         ('create_timer(0.5', 'create_timer(0.2')],
        # A second thread brings what the callback waits for.
        [('rclpy.spin(Guard())', 'executor = MultiThreadedExecutor()\n        executor.add_node(Guard())\n        '
          'executor.spin()'), ('import ExternalShutdownException', 'import ExternalShutdownException, '
          'MultiThreadedExecutor'),
         ('self.create_timer(0.5, self.ask)', 'self.create_timer(0.5, self.ask, MutuallyExclusiveCallbackGroup())'),
         ('import Node\n', 'import Node\nfrom rclpy.callback_groups import MutuallyExclusiveCallbackGroup\n'),
         ("future = self.getter.call_async(GetParameters.Request(names=['max_speed_rpm']))",
          "answer = self.getter.call(GetParameters.Request(names=['max_speed_rpm']))"),
         ('future.add_done_callback(self.on_speed)', 'self.on_speed(answer)'),
         ('future.result().values', 'future.values')],
    ],
}
