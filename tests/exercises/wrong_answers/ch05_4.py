"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.4."""

# In the solution: the line that asks, and what makes the client.
ASK = 'answer = await self.client.call_async(request)'
GROUP = 'callback_group=MutuallyExclusiveCallbackGroup()'
CLIENT = ('self.client = self.create_client(\n            SetParametersAtomically, '
          f"'driver/set_parameters_atomically',\n            {GROUP})")
_READ = ('if not answer.result.successful:\n            self.rejection = answer.result.reason')
_SERVICE = "'driver/set_parameters_atomically'"
_SYNC = ('async def slow_down', 'def slow_down')
# With a callback in place of the pause.
_CALLBACK = [_SYNC, (ASK, 'self.client.call_async(request).add_done_callback(self.on_answer)\n\n'
                          '    def on_answer(self, future):\n        answer = future.result()')]

WRONG = {
    '5.4a': [
        ([(_SERVICE, "'driver/set_parameters'")], 0,
         'the service `/driver/set_parameters` is of another type than the client'),
        # Hangs under rclpy.spin: the timer and the client are in one group.
        ([(f',\n            {GROUP}', '')], 0, 'Does the client have a group of its own?'),
        # Blocked: for good, for a while, and in loops.
        ([_SYNC, (ASK, 'answer = self.client.call(request)')], 0, 'Use call_async()'),
        ([(ASK, 'answer = self.client.call(request)')], 0, 'Use call_async()'),
        ([(ASK, 'answer = await self.client.call(request)')], 0, 'Use call_async()'),
        ([(ASK, 'answer = self.client.call_async(request)')], 0, 'It is a future, whose answer has still to come'),
        ([(ASK, 'answer = self.client.call_async(request).result()')], 0,
         '`result()` of a future does not wait for it'),
        ([(ASK, 'import rclpy\n        future = self.client.call_async(request)\n'
           '        rclpy.spin_until_future_complete(self, future)\n        answer = future.result()')],
         0, 'this callback already runs inside the executor that it waits for'),
        ([(ASK, 'future = self.client.call_async(request)\n        while not future.done():\n            pass\n'
           '        answer = future.result()')], 0, 'it was still running after some seconds'),
        ([(ASK, f'import time\n        time.sleep(0.5)\n        {ASK}')], 0, 'time.sleep() blocks the thread'),
        # Waits for a driver that is not there.
        ([(ASK, f'while not self.client.wait_for_service(timeout_sec=1.0):\n            pass\n        {ASK}')], 2,
         'So does whatever sleeps inside, as wait_for_service() does'),
        ([(ASK, f'while not self.client.service_is_ready():\n            pass\n        {ASK}')], 2,
         'it was still running after some seconds'),
        ([(f'{GROUP})\n', f'{GROUP})\n        self.client.wait_for_service()\n')], 2, 'still running after'),
        ([(ASK, f'if not self.client.service_is_ready():\n            raise RuntimeError("no driver")\n        {ASK}')],
         2, 'RuntimeError: no driver'),
        # Not atomic.
        ([('SetParametersAtomically', 'SetParameters'), ('set_parameters_atomically', 'set_parameters'),
          ('class Supervisor', 'from rcl_interfaces.srv import SetParameters\n\n\nclass Supervisor'),
          (_READ, 'result = min(answer.results, key=lambda each: each.successful)\n'
                  '        self.rejection = result.reason')],
         2, '`set_parameters` decides about each parameter separately'),
        ([(_SERVICE, "'drver/set_parameters_atomically'")], 0,
         'there is no service `drver/set_parameters_atomically` of that type'),
        ([(CLIENT, 'pass')], 0, 'it creates none'),
        ([('value=1.0)]', "value=1.0), Parameter('use_sim_time', value=False)]")], 2,
         'it is asked for `use_sim_time` too'),
        ([('answer.result.successful', 'answer.results[0].successful')], 0, 'AttributeError'),
        ([('self.rejection = answer.result.reason', 'self.rejection = str(answer.result)')], 2, 'rcl_interfaces.msg'),
        ([('self.rejection = answer.result.reason', "self.rejection = 'rejected'")], 2, "it is `'rejected'`"),
        ([('if not answer.result.successful:', 'if True:'),
          ('= answer.result.reason', "= answer.result.reason or 'ok'")], 2, "it is `'ok'`"),
        ([('value=0.3', 'value=0.03')], 0, 'it holds 0.03 and 1.0'),
        ([('value=1.0', 'value=1')], 0, "`self.rejection` is `\"Wrong parameter type, expected 'Type.DOUBLE'"),
        ([(ASK, 'answer = self.set_parameters_atomically(wanted)')], 0, 'ParameterNotDeclaredException'),
        ([('def slow_down', 'def slowdown')], 0, 'the class has none'),
        ([("super().__init__('supervisor')", "super().__init__('boss')")], 3, 'it is called `boss`'),
    ],
    '5.4b': [
        ([("'call, the timer in its own group': 'hangs'", "'call, the timer in its own group': 'answered'")], 6,
         "it does not say `'answered'`"),
        ([("'await, both in one more group': 'hangs'", "'await, both in one more group': 'answered'")], 6,
         "it does not say `'answered'`"),
        ([("one reentrant group': 'answered'", "one reentrant group': 'hangs'")], 6, "it does not say `'hangs'`"),
        ([("'await, both in the default group': 'hangs'", "'await, both in the default group': 'waits'")], 6,
         'is none of these words'),
    ],
}

RIGHT = {
    '5.4a': [
        [('MutuallyExclusiveCallbackGroup()', '__import__("rclpy.callback_groups").callback_groups.'
          'ReentrantCallbackGroup()')],
        _CALLBACK,
        [*_CALLBACK, (f',\n            {GROUP}', '')],
        # rclpy's own client.
        [(CLIENT, "from rclpy.parameter_client import AsyncParameterClient\n        self.box = AsyncParameterClient("
                  f"self, 'driver', {GROUP})"),
         (ASK, 'answer = await self.box.set_parameters_atomically(wanted)')],
        # In a thread of its own, which may block.
        [_SYNC, (ASK, 'import threading\n        threading.Thread(target=self.ask, args=[request], daemon=True).start()'
                      '\n\n    def ask(self, request):\n        answer = self.client.call(request)')],
        # A timer looks for the answer.
        [_SYNC, (ASK, 'self.future = self.client.call_async(request)\n        self.timer = self.create_timer(0.05, '
                      'self.look)\n\n    def look(self):\n        if not self.future.done():\n            return\n'
                      '        self.timer.cancel()\n        answer = self.future.result()')],
        [(ASK, f'if not self.client.service_is_ready():\n            return\n        {ASK}')],
        [(_SERVICE, f"'/{_SERVICE[1:]}")],
        [("'max_speed_mps', value", "'max_speed_mps', Parameter.Type.DOUBLE, value")],
    ],
    '5.4b': [[("'hangs'", "' Hangs.'")]],
}
