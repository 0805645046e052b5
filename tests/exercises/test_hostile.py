"""Lines that hang a kernel or end a stage elsewhere, in a real kernel: each gets a word, and work goes on."""

import pytest

from tests.support.hostile import IN_THE_CELL, LINES, PLACES, attempt, started

pytestmark = pytest.mark.slow

# Every line in a callback; thoroughly, in one more place, and the most common line in all of them.
TRIED = [pytest.param(name, place, marks=() if place == 'timer' else pytest.mark.thorough)
         for turn, name in enumerate(LINES)
         for place in (PLACES if name == 'spin' else dict.fromkeys(('timer', list(PLACES)[turn % len(PLACES)])))]


@pytest.fixture(scope='module')
def kernels():
    """One kernel for all tests, or a new one after one that hangs."""
    kernels = []
    yield kernels
    for kernel in kernels:
        kernel.kill()


@pytest.fixture
def kernel():
    """A kernel for one test, with the stage in it."""
    kernel = started()
    yield kernel
    kernel.kill()


@pytest.mark.parametrize(('name', 'place'), TRIED)
def test_a_hostile_line_gets_a_word_and_work_goes_on(kernels, name, place):
    if not kernels:
        kernels.append(started())
    try:
        tried = attempt(kernels[0], name, place)
    except TimeoutError:
        kernels.pop().kill()
        raise
    assert tried.goes_on == (True, True), tried
    if place in IN_THE_CELL and name == 'input':
        assert 'seven' in tried.text
    else:
        assert tried.says(LINES[name].says), tried.text
        # Jupyter Server limits what a kernel may send, and so spares the browser a flood.
        assert len(tried.text) < 30_000 or name == 'print flood'


def test_the_context_of_the_stage_survives_an_interrupt_in_a_cell_with_init(kernel):
    text = kernel.run("rclpy.init()\nprint('busy', flush=True)\ntime.sleep(600)", interrupt_on='busy')
    assert 'KeyboardInterrupt' in text
    assert kernel.run("ParameterClient('keeper').get_parameter('x'), rclpy.ok()") == '(1, True)'
    assert kernel.end() == 0
