"""Nodes for tests of panels and clients."""

import math
import threading

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, SetParametersResult
from rcl_interfaces.msg import ParameterDescriptor as Describe
from rclpy.node import Node
from rclpy.parameter import Parameter

INT64_MAX = 2**63 - 1


class Arm(Node):
    """Has a parameter of every type and shape."""

    def __init__(self):
        super().__init__('arm')
        declare = self.declare_parameter
        declare('enabled', True)
        declare('serial', 2**62 + 1)
        declare('joints', 5, Describe(integer_range=[IntegerRange(from_value=1, to_value=12, step=4)]))
        declare('offset', 0.5)
        declare('reach', 0.5, Describe(floating_point_range=[FloatingPointRange(from_value=0.01, to_value=2.0)]))
        declare('gains.kp', 0.3, Describe(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.3)]))
        declare('gains.ki', 0.0)
        declare('tool', 'gripper')
        declare('notes', 'one\ntwo')
        declare('flags', [True, False])
        declare('order', [3, 1, 2])
        declare('limits', [-1.5, math.inf])
        declare('names', ['base', 'elbow, left'])
        declare('firmware', [b'\x00', b'\xff'])
        declare('model', 'A1', Describe(read_only=True))
        declare('payload', 1.5, Describe(dynamic_typing=True))
        declare('calibrated_at', Parameter.Type.STRING)
        declare('endless', 1.0, Describe(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=math.inf)]))
        declare('fixed', 7, Describe(integer_range=[IntegerRange(from_value=7, to_value=7, step=1)]))
        declare('huge', 0, Describe(
            integer_range=[IntegerRange(from_value=-INT64_MAX, to_value=INT64_MAX, step=1)]))


class Band(Node):
    """Accepts a lower end only below its upper one."""

    def __init__(self):
        super().__init__('band')
        self.declare_parameters('', [('low', 1), ('high', 2), ('name', 'band')])
        self.declare_parameter('serial', 'SN-1', Describe(read_only=True))
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters):
        """Look at the values as they would be after the whole change."""
        new = {parameter.name: parameter.value for parameter in parameters}
        low, high = (new.get(name, self.get_parameter(name).value) for name in ('low', 'high'))
        return SetParametersResult(successful=low < high, reason=f'{low} is not below {high}')


class Gate(Node):
    """Lets each value through only when the test opens the gate, and keeps what it saw."""

    def __init__(self):
        super().__init__('gate')
        self.declare_parameter('x', 0)
        self.declare_parameter('y', 0)
        self.seen = []
        self.entered = threading.Semaphore(0)
        self.open = threading.Semaphore(0)
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        """Wait at the gate."""
        self.seen.append(parameters[0].value)
        self.entered.release()
        self.open.acquire(timeout=20)
        return SetParametersResult(successful=parameters[0].value >= 0, reason='must not be negative')


class Counter(Node):
    """Counts the values that it is asked for."""

    def __init__(self):
        super().__init__('counter')
        self.declare_parameter('x', 0)
        self.seen = []
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        """Accept everything."""
        self.seen += [each.value for each in parameters]
        return SetParametersResult(successful=True)


class Weather(Node):
    """Has two numbers that depend on each other."""

    def __init__(self, name='weather'):
        super().__init__(name)
        self.declare_parameter('low_c', -5)
        self.declare_parameter('high_c', 40)
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters):
        """Look at the values as they would be after the whole change."""
        after = {name: self.get_parameter(name).value for name in ('low_c', 'high_c')}
        after.update((each.name, each.value) for each in parameters)
        return SetParametersResult(successful=after['low_c'] < after['high_c'], reason='low_c must be below high_c')
