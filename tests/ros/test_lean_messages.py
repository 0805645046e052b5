"""What start() leaves out of a process is still there for anyone who wants it."""

import subprocess
import sys

import pytest
from rclpy.node import Node

START = 'import param_tutorial; param_tutorial.start()'
COMMAND = ('sys.argv[1:] = ["node", "info", "/speaking"]\n'
           'import param_tutorial.__main__ as m; assert m.main() == 0')
GENERATOR = 'rosidl_generator_py.generate_py_impl'


def output_of(program: str) -> list[str]:
    done = subprocess.run([sys.executable, '-c', f'import sys\n{program}'], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


@pytest.mark.slow
@pytest.mark.parametrize('program', [START, COMMAND])
def test_neither_numpy_nor_the_code_generator_is_loaded(ros, program):
    ros.add(Node, 'speaking')
    assert output_of(f'{program}\nprint([name for name in ("numpy", "lark", "{GENERATOR}") if name in sys.modules])'
                     )[-1] == '[]'


@pytest.mark.slow
def test_who_wants_them_gets_them(ros):
    assert output_of(f'{START}\n'
                     'from service_msgs.msg import ServiceEventInfo\n'
                     'print(ServiceEventInfo().client_gid.tolist() == [0] * 16)\n'
                     'import numpy.linalg; print(numpy.ones(2).sum(), numpy is sys.modules["numpy"])\n'
                     f'import {GENERATOR} as generator; print(callable(generator.generate_py))'
                     ) == ['True', '2.0 True', 'True']


@pytest.mark.slow
def test_those_that_are_there_stay(ros):
    assert output_of(f'import numpy, {GENERATOR} as generator\n'
                     f'{START}\n'
                     f'print(sys.modules["numpy"] is numpy, sys.modules["{GENERATOR}"] is generator)\n'
                     'from service_msgs.msg import _service_event_info\n'
                     'print(_service_event_info.numpy is numpy)') == ['True True', 'True']
