"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.1."""

_SUBSCRIBE = ("        self.create_subscription(\n            ParameterEvent, '/parameter_events', self.on_event, "
              'qos_profile_parameter_events)\n')

WRONG = {
    '10.1a': [
        ([(_SUBSCRIBE, '')], 0, 'it does not'),
        ([("'/parameter_events', self.on_event", "'/parameter_event', self.on_event")], 0, 'it does not'),
        ([('self.on_event, qos_profile_parameter_events', 'self.on_event, 10')], 3, 'it is 10'),
        ([("event.node == '/driver'", "event.node == 'driver'")], 1, 'it holds 0.9'),
        ([("event.node == '/driver'", "event.node.startswith('/driver')")], 3, 'the driver has been asked for'),
        ([("event.node == '/driver'", 'event.node')], 3, 'the driver has been asked for'),
        ([('[*event.new_parameters, *event.changed_parameters]', 'event.changed_parameters')], 3, 'it holds 0.9'),
        ([('[*event.new_parameters, *event.changed_parameters]', 'event.new_parameters')], 1, 'it holds 0.9'),
        ([("parameter.name == 'max_speed_mps':\n                    self.slow",
           'parameter.value:\n                    self.slow')], 3, 'the driver has been asked for'),
        ([('self.slow_down(parameter_value_to_python(parameter.value))', 'self.ask()')], 1, 'it holds 0.9'),
        ([('parameter_value_to_python(parameter.value)', 'parameter.value')], 0, 'TypeError'),
        ([('parameter_value_to_python(parameter.value)', 'parameter.value.integer_value')], 1, 'it holds 0.9'),
        ([('event.changed_parameters', 'event.set_parameters')], 0, "object has no attribute 'set_parameters'"),
    ],
    '10.1b': [
        ([("with three parameters': 3", "with three parameters': 1")], 6, 'one after the other, and publishes each'),
        ([("atomically with three parameters': 1", "atomically with three parameters': 3")], 6, 'in one go'),
        ([("set_parameters with two, of which one is rejected': 1",
           "set_parameters with two, of which one is rejected': 0")], 6, 'it stores the other one'),
        ([("atomically with two, of which one is rejected': 0", "atomically with two, of which one is rejected': 1")],
         6, 'All or nothing'),
        ([("already': 1", "already': 0")], 6, 'A node does not compare'),
        ([("two parameters': 2", "two parameters': 1")], 6, 'It declares one after the other'),
        ([("undeclare_parameter': 0", "undeclare_parameter': 1")], 6, 'The only deletion that is published'),
    ],
    '10.1c': [
        # The chain of the article.
        ([('parameter_value_to_python(parameter.value)',
           'parameter.value.string_value or parameter.value.integer_value or parameter.value.double_value '
           'or parameter.value.bool_value')], 3, "there is `('changed', 'offset', False)`"),
        ([("'deleted', parameter.name, None", "'deleted', parameter.name, parameter.name")], 3,
         "there is `('deleted', 'lamp', 'lamp')`"),
        ([("if event.node == '/rover':", 'if event.node:')], 3, "('changed', 'speed', 3), "),
        ([('self.write, qos_profile_parameter_events', 'self.write, 10')], 3, 'there are 10'),
        # Raises an exception at each event: reported once, by name.
        ([('event.deleted_parameters', 'event.removed_parameters')], 0,
         "the subscription callback write of /journal raised AttributeError: 'ParameterEvent' object has no attribute "
         "'removed_parameters'"),
        ([("if event.node == '/rover':", "self.pagse\n        if event.node == '/rover':")], 0,
         'the subscription callback write of /journal raised AttributeError'),
        ([("if event.node == '/rover':", "if event.node == 'rover':")], 0, 'there are none'),
        ([("if event.node == '/rover':", "if event.node.endswith('/rover'):")], 3, "('changed', 'speed', 4)"),
        ([("if event.node == '/rover':", "if event.node.startswith('/rover'):")], 3, "('changed', 'speed', 3)"),
        ([('            for parameter in event.deleted_parameters:\n'
           "                self.pages.append(('deleted', parameter.name, None))", '')], 3,
         "('changed', 'lamp', 3), ('new', 'target', 2.5)]`"),
        # Writes down only what differs from the page before.
        ([("                self.pages.append(('changed', parameter.name, parameter_value_to_python(parameter.value)))",
           "                page = 'changed', parameter.name, parameter_value_to_python(parameter.value)\n"
           "                if page not in self.pages[-1:]:\n                    self.pages.append(page)")], 3,
         "the pages are `[('new', 'lamp', 2), ('changed', 'lamp', 3), ('deleted', 'lamp', None), "),
        # One of several parameters in an event.
        ([('in event.changed_parameters', 'in event.changed_parameters[:1]')], 3,
         "[('changed', 'speed', 7), ('new', 'lamp', 0)]"),
        ([("('changed', parameter.name, parameter_value_to_python(parameter.value))",
           "('changed', parameter.name, str(parameter_value_to_python(parameter.value)))")], 3,
         "there is `('changed', 'speed', '7')`"),
        ([("('changed', parameter.name, parameter_value_to_python(parameter.value))",
           "['changed', parameter.name, parameter_value_to_python(parameter.value)]")], 3, "[['changed', 'speed', 7]"),
        ([("'/parameter_events'", "'/parameter_event'")], 0, 'it does not'),
        ([('self.pages = []', 'self.page = []'), ('self.pages.append', 'self.page.append')], 0, 'it has none'),
        ([('self.write, qos_profile_parameter_events',
           "self.write, __import__('rclpy').qos.QoSProfile(depth=1000, durability=1)")], 0, 'they do not'),
        # The message in place of its value.
        ([("('changed', parameter.name, parameter_value_to_python(parameter.value))",
           "('changed', parameter.name, parameter.value)")], 3, "there is `('changed', 'speed', rcl_interfaces.msg"),
        # One shared list, whose last entry is written into each page.
        ([('self.pages = []', 'self.pages, self.now = [], []'),
          ("                self.pages.append(('changed', parameter.name, parameter_value_to_python(parameter.value)))",
           "                self.now[:] = [parameter_value_to_python(parameter.value)]\n"
           "                self.pages.append(('changed', parameter.name, self.now))")],
         2, "there is `('changed', 'speed', ["),
        ([('        if event.node', "        __import__('rclpy').spin_once(self)\n        if event.node")], 0,
         'already runs inside the executor'),
        ([('        if event.node', '        while True:\n            pass\n        if event.node')],
         0, 'did not return'),
        ([('        if event.node', '        from time import sleep\n        sleep(4.0)\n        if event.node')], 0,
         'it waits, and keeps the executor busy meanwhile'),
    ],
}

RIGHT = {
    '10.1a': [
        [('parameter_value_to_python(parameter.value)', 'parameter.value.double_value')],
        [('[*event.new_parameters, *event.changed_parameters]',
          'list(event.new_parameters) + list(event.changed_parameters)'),
         ("'/parameter_events'", "'parameter_events'")],
        [(_SUBSCRIBE, '        from rclpy.parameter_event_handler import ParameterEventHandler\n'
          '        self.handler = ParameterEventHandler(self)\n'
          '        self.handler.add_parameter_event_callback(self.on_event)\n')],
    ],
    '10.1c': [
        # A relative name, keywords, and your own profile.
        [("'/parameter_events', self.write", "'parameter_events', self.write")],
        [("ParameterEvent, '/parameter_events', self.write, qos_profile_parameter_events",
          "msg_type=ParameterEvent, topic='/parameter_events', callback=self.write, qos_profile=500")],
        [('def write', 'async def write'), ("event.node == '/rover'", "event.node.lstrip('/') == 'rover'")],
        # As short as the burst, and no shorter.
        [('self.write, qos_profile_parameter_events', 'self.write, 200')],
        [("self.create_subscription(ParameterEvent, '/parameter_events', self.write, qos_profile_parameter_events)",
          'from rclpy.parameter_event_handler import ParameterEventHandler\n'
          '        self.handler = ParameterEventHandler(self)\n'
          '        self.handler.add_parameter_event_callback(self.write)')],
        [("self.create_subscription(ParameterEvent, '/parameter_events', self.write, qos_profile_parameter_events)",
          "from rclpy.parameter_client import AsyncParameterClient\n"
          "        AsyncParameterClient(self, '/rover').on_parameter_event(self.write)")],
        # Writes down later what it hears, and reads the values in another way.
        [('self.write, qos_profile_parameter_events)',
          'self.hear, qos_profile_parameter_events)\n'
          '        self.heard = []\n'
          '        self.create_timer(0.1, self.write_all)\n\n'
          '    def hear(self, event):\n'
          '        self.heard.append(event)\n\n'
          '    def write_all(self):\n'
          '        while self.heard:\n'
          '            self.write(self.heard.pop(0))'),
         ('parameter_value_to_python(parameter.value)',
          "__import__('rclpy').parameter.Parameter.from_parameter_msg(parameter).value")],
        [("                self.pages.append(('new', parameter.name, parameter_value_to_python(parameter.value)))",
          "                self.pages = [*self.pages, ('new', parameter.name, "
          "parameter_value_to_python(parameter.value))]")],
    ],
}
