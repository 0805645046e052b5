"""The state machine behind a panel, without threads, without ROS and without a clock."""

from types import SimpleNamespace

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from param_tools import values
from param_tools.errors import (
    CallbackError,
    ExecutorError,
    NoAnswerError,
    NodeGoneError,
    NodeNotFoundError,
    ParameterNotDeclaredError,
)
from param_tools.node import live_state
from param_tools.node.live_state import NOTHING, Change, LiveState, ParameterState, Request, Todo

NODE = '/arm'
TIMEOUT_SEC = 3.0
HERE, AGAIN = frozenset({b'first'}), frozenset({b'second'})
ABSENCE = '/arm is not running. Its controls come back when it does.'


def descriptor(name, parameter_type=values.INTEGER):
    return SimpleNamespace(name=name, type=parameter_type)


def describe(state, **present):
    """Let a state read everything, and return what it asks for next."""
    assert state.begin_reading(0.0).describe
    return state.described(list(present), {name: descriptor(name) for name in present}, present)


def changed(name, value):
    return Change(name, values.INTEGER.number, value)


@pytest.fixture
def state():
    """Return the state of a node that is there, with x = 1, read and shown."""
    state = LiveState(NODE, TIMEOUT_SEC)
    assert state.executor_found(HERE) == Todo(read=True)
    assert describe(state, x=1) == Todo(show=True)
    assert state.begin_showing(0.0) == NOTHING
    assert state.is_settled
    return state


@pytest.fixture
def x(state):
    return state.parameters['x']


# -- asking -----------------------------------------------------------------------------------------------


def test_what_is_asked_for_is_sent_at_once_and_read_back_when_it_is_answered(state, x):
    todo = state.ask(x, 2, 10.0)
    assert (todo.send.parameter, todo.send.value, todo.watch) == (x, 2, True)
    assert (x.busy, x.value, x.asked_at, state.busy_names) == (True, 1, 10.0, ['x'])
    assert state.answered(todo.send, '', 10.1) == Todo(read=True)
    assert (x.busy, x.value, x.message) == (False, 2, '')
    assert state.begin_reading(10.1).names == ['x']
    assert state.have_read({'x': 3}) == Todo(show=True)  # the node has made something else of it
    assert x.value == 3
    assert not state.is_settled
    state.begin_showing(10.2)
    assert state.is_settled


@pytest.mark.parametrize(('error', 'read'), [
    (CallbackError(NODE, 'set_parameters', ValueError('x')), True),  # before or after it was stored
    (RuntimeError('x'), True),
    (NodeGoneError(NODE, 'set_parameters'), False),
])
def test_an_error_in_place_of_the_answer_is_shown_and_the_node_read_if_it_can_be(state, x, error, read):
    assert state.answer_failed(state.ask(x, 2, 10.0).send, error, 10.1) == Todo(read=read, show=not read)
    assert (x.value, x.busy) == (1, False)
    assert str(error) in x.message


def test_a_node_that_was_not_found_is_looked_for(state, x):
    assert state.send_failed(state.ask(x, 2, 10.0).send, NodeNotFoundError(NODE, []), 10.0).read
    assert state.begin_reading(10.0).describe
    assert 'there is no node /arm' in x.message


def test_an_answer_about_a_parameter_that_was_deleted_meanwhile_is_shown_though_nothing_can_be_read(state, x):
    request = state.ask(x, 2, 10.0).send
    state.refresh()
    describe(state, y=1)
    assert state.answered(request, 'not declared', 10.1) == Todo(show=True)
    assert state.begin_reading(10.2) is None
    state.begin_showing(10.2)
    assert state.is_settled


# -- what the node reports ------------------------------------------------------------------------------


def test_a_change_is_read_unless_it_is_known(state):
    assert state.changed([changed('x', 1)], others=False) == NOTHING
    assert state.changed([changed('stranger', 1)], others=False) == NOTHING
    assert state.changed([changed('x', 2)], others=False) == Todo(read=True)
    reading = state.begin_reading(0.0)
    assert (reading.describe, reading.names) == (False, ['x'])


@pytest.mark.parametrize(('changes', 'others'), [
    ([], True), ([Change('x', values.STRING.number, 'two')], False), ([Change('x', 77, None)], False)])
def test_what_came_went_or_has_another_type_is_described(state, changes, others):
    assert state.changed(changes, others=others) == Todo(read=True)
    assert state.begin_reading(0.0).describe


def test_a_stranger_that_changes_while_everything_is_read_is_not_waited_for(state):
    state.refresh()
    assert state.begin_reading(0.0).describe
    state.changed([changed('stranger', 1)], others=False)
    assert state.described(['x'], {'x': descriptor('x')}, {'x': 1}) == Todo(show=True)
    state.begin_showing(0.0)
    assert state.is_settled


# -- coming and going -----------------------------------------------------------------------------------


def test_a_node_that_goes_takes_its_requests_along_and_is_described_when_it_comes_back(state, x):
    state.ask(x, 2, 10.0)
    state.ask(x, 3, 10.0)
    assert state.graph_changed(frozenset(), is_ready=False) == Todo(show=True)
    assert (state.status, x.busy, x.waiting, x.message) == (ABSENCE, False, None, ABSENCE)
    assert state.begin_reading(10.0) is None
    assert state.read_again_in(10.0) is None
    assert state.graph_changed(AGAIN, is_ready=True).read
    describe(state, x=7)
    assert (state.status, state.parameters['x'] is x, x.value, x.message) == ('', True, 7, '')


def test_a_node_restarted_while_it_is_described_is_described_again(state, x):
    state.refresh()
    state.begin_reading(10.0)
    state.graph_changed(AGAIN, is_ready=True)
    assert state.described(['x'], {'x': descriptor('x')}, {'x': 5}).read
    assert state.begin_reading(10.0).describe


def test_an_answer_from_a_node_that_has_gone_meanwhile_does_not_bring_it_back(state):
    state.refresh()
    state.begin_reading(10.0)
    state.graph_changed(frozenset(), is_ready=False)
    assert state.described(['x'], {'x': descriptor('x')}, {'x': 5}) == NOTHING
    assert state.status == ABSENCE


def test_without_an_executor_nothing_is_tried(state, x):
    state.refresh()
    state.begin_reading(10.0)
    state.executor_lost('no executor is running')
    assert state.reading_failed(ExecutorError('stopped'), 10.0) == NOTHING
    assert state.status == 'no executor is running'
    assert (state.read_again_in(10.0), state.begin_reading(20.0)) == (None, None)
    assert state.graph_changed(HERE, is_ready=True) == NOTHING
    assert state.executor_found(AGAIN).read
    describe(state, x=1)
    assert state.status == ''


def test_a_node_that_does_not_answer_is_asked_again_later(state):
    state.refresh()
    state.begin_reading(10.0)
    state.reading_failed(NoAnswerError(NODE, 'list_parameters', 3.0), 13.0)
    assert 'did not answer' in state.status
    assert state.read_again_in(13.0) == live_state.RETRY_PERIOD_SEC
    assert state.begin_reading(13.5) is None
    assert state.begin_reading(14.0).describe


def test_what_was_said_of_a_lost_node_is_not_said_of_one_that_comes_and_is_silent_at_first(state, x):
    state.graph_changed(frozenset(), is_ready=False)
    state.send_failed(state.ask(x, 2, 10.0).send, NodeNotFoundError(NODE, []), 10.0)
    assert state.graph_changed(AGAIN, is_ready=False).read
    assert state.begin_reading(11.0).describe
    state.reading_failed(NoAnswerError(NODE, 'list_parameters', 3.0), 14.0)
    assert 'did not answer' in state.status
    assert state.begin_reading(15.1).describe
    state.described(['x'], {'x': descriptor('x')}, {'x': 1})
    assert (state.status, x.message) == ('', '')


def test_a_node_that_does_not_answer_to_a_change_is_silent_until_it_answers_anything(state, x):
    silent = NoAnswerError(NODE, 'set_parameters', 3.0)
    assert state.answer_failed(state.ask(x, 2, 10.0).send, silent, 13.0) == Todo(read=True, show=True)
    assert (state.status, x.message, x.value) == (str(silent), str(silent), 1)
    assert state.begin_reading(13.0).describe
    state.reading_failed(NoAnswerError(NODE, 'list_parameters', 3.0), 16.0)
    assert 'did not answer list_parameters' in state.status
    assert state.begin_reading(17.0).describe
    state.described(['x'], {'x': descriptor('x')}, {'x': 1})
    # The person who asked should still see that there was no answer.
    assert (state.status, x.message, x.is_unanswered) == ('', str(silent), True)
    # Until the node has done what it was asked to, or the person asks for something else.
    state.changed([changed('x', 3)], others=False)
    assert state.begin_reading(18.0).names == ['x']
    state.have_read({'x': 3})
    assert x.message
    state.changed([changed('x', 2)], others=False)
    state.begin_reading(19.0)
    state.have_read({'x': 2})
    assert (x.value, x.message, x.is_unanswered) == (2, '', False)


def test_a_node_that_is_not_found_though_the_graph_shows_it_is_asked_again_later(state):
    state.refresh()
    state.begin_reading(10.0)
    state.reading_failed(NodeNotFoundError(NODE, []), 13.0)
    assert state.status == ABSENCE
    assert state.begin_reading(14.0).describe


def test_a_node_that_never_was_is_named_with_its_likeliest_neighbors():
    state = LiveState(NODE, TIMEOUT_SEC)
    state.executor_found(frozenset())
    state.begin_reading(0.0)
    state.reading_failed(NodeNotFoundError(NODE, ['/arms']), 3.0)
    assert 'Did you mean /arms?' in state.status
    assert state.read_again_in(3.0) is None


def test_a_parameter_deleted_before_it_was_read_leads_to_a_description(state):
    state.changed([changed('x', 2)], others=False)
    state.begin_reading(0.0)
    assert state.reading_failed(ParameterNotDeclaredError(NODE, 'x', []), 0.0).read
    assert state.begin_reading(0.0).describe


def test_a_node_without_events_is_looked_after_and_missed():
    state = LiveState(NODE, TIMEOUT_SEC)
    state.executor_found(frozenset())
    describe(state, x=1)
    assert state.is_unseen
    assert state.read_again_in(0.0) == live_state.UNSEEN_PERIOD_SEC
    assert state.missed().show
    assert (state.status, state.missed()) == (ABSENCE, NOTHING)
    assert state.graph_changed(frozenset(), is_ready=True).read


def test_closed_it_reads_no_more_and_waits_for_nothing(state, x):
    request = state.ask(x, 2, 10.0).send
    state.close()
    state.refresh()
    assert (state.busy_names, state.begin_reading(11.0), state.read_again_in(11.0)) == ([], None, None)
    assert state.answered(request, '', 11.0) == NOTHING


# -- any events in any order ------------------------------------------------------------------------------


# Few, so that things coincide.
NAMES = st.sampled_from(['x', 'y'])
NUMBERS = st.integers(-1, 1)
COUNTS = st.integers(0, 2)


class AnyOrder(RuleBasedStateMachine):
    """A node, the ways to it and from it, a reader and a shower, all of which take any time they like.

    The node stores what is not negative. What has been sent, answered or published waits here until a rule lets it go
    on; only events keep their order. Reader and shower do something only when the state machine has asked for it. The
    node stays: when one comes, everything is read again, and a change that was missed would be found.
    """

    def __init__(self):
        super().__init__()
        self.state = LiveState(NODE, TIMEOUT_SEC)
        self.now = 100.0
        # The node.
        self.stored = {'x': 0, 'y': 0}
        # Under way.
        self.requests: list[Request] = []
        self.answers: list[tuple[Request, str | Exception]] = []
        self.events: list[list[Change]] = []
        self.reading = self.result = None
        # What a shell keeps.
        self.must_read = self.must_show = self.watching = False
        self.shown: dict[str, int] = {}
        # What is expected.
        self.under_way: dict[ParameterState, Request] = {}
        self.wanted: dict[ParameterState, int] = {}

    @initialize()
    def begin(self):
        self.do(self.state.executor_found(HERE))

    def do(self, todo):
        for parameter in [each for each in self.under_way if not each.busy]:
            assert parameter.message or self.state.closed
            del self.under_way[parameter]
            self.wanted.pop(parameter, None)
        self.must_read |= todo.read
        self.must_show |= todo.show
        self.watching |= todo.watch
        if todo.send is not None:
            parameter = todo.send.parameter
            assert parameter not in self.under_way, 'two requests at once'
            self.under_way[parameter] = todo.send
            if self.wanted[parameter] == todo.send.value:
                del self.wanted[parameter]
            self.requests.append(todo.send)

    # -- the user

    @rule(name=NAMES, value=NUMBERS)
    def ask(self, name, value):
        parameter = self.state.parameters.get(name)
        if parameter is not None:
            self.wanted[parameter] = value
            self.do(self.state.ask(parameter, value, self.now))

    @rule(name=NAMES)
    def reject(self, name):
        parameter = self.state.parameters.get(name)
        if parameter is not None:
            self.wanted.pop(parameter, None)
            self.do(self.state.reject(parameter, 'no number'))

    # -- the node, and the ways from it

    @precondition(lambda self: self.requests)
    @rule(index=COUNTS, lost=st.booleans())
    def serve(self, index, lost=False):
        request = self.requests.pop(index % len(self.requests))
        answer = 'negative'
        if request.value >= 0:
            answer = ''
            self.store(request.parameter.name, request.value)
        self.answers.append((request, NoAnswerError(NODE, 'set_parameters', 3.0) if lost else answer))

    def store(self, name, value):
        self.stored[name] = value
        self.events.append([changed(name, value)])

    @rule(name=NAMES, value=NUMBERS)
    def change_elsewhere(self, name, value):
        self.store(name, value)

    @rule(name=NAMES, value=NUMBERS)
    def change_and_report(self, name, value):
        self.change_elsewhere(name, value)
        while self.events:
            self.deliver_event()

    @precondition(lambda self: self.answers)
    @rule(index=COUNTS)
    def deliver_answer(self, index):
        request, answer = self.answers.pop(index % len(self.answers))
        parameter = request.parameter
        if self.under_way.get(parameter) is request:
            del self.under_way[parameter]
        else:  # it was given up
            before = vars(parameter).copy(), vars(self.state).copy()
        late = parameter.request is not request
        report = self.state.answered if isinstance(answer, str) else self.state.answer_failed
        todo = report(request, answer, self.now)
        if late:
            assert todo == NOTHING
            assert (vars(parameter), vars(self.state)) == before
        self.do(todo)

    @precondition(lambda self: self.events)
    @rule()
    def deliver_event(self):
        self.do(self.state.changed(self.events.pop(0), others=False))

    # -- the workers, and time

    @rule(seconds=st.sampled_from([0.1, 1.0, 5.0]))
    def wait(self, seconds):
        self.now += seconds

    @precondition(lambda self: self.reading is None)
    @rule()
    def begin_reading(self):
        if self.must_read or self.state.read_again_in(self.now) is not None:
            self.must_read = False
            self.reading = self.state.begin_reading(self.now)

    @precondition(lambda self: self.reading is not None and self.result is None)
    @rule()
    def answer_reading(self):
        self.result = self.stored.copy()

    @precondition(lambda self: self.result is not None)
    @rule()
    def end_reading(self):
        reading, result, self.reading, self.result = self.reading, self.result, None, None
        busy = {each: each.value for each in self.state.parameters.values() if each.busy}
        if reading.describe:
            self.do(self.state.described(list(result), {name: descriptor(name) for name in result}, result))
        else:
            self.do(self.state.have_read({name: result[name] for name in reading.names}))
        assert all(each.value == value for each, value in busy.items()), 'a busy parameter was overwritten'

    @rule()
    def show(self):
        if self.must_show or self.watching:
            self.must_show = False
            self.do(self.state.begin_showing(self.now))
            self.watching = bool(self.state.busy_names)
            self.shown = {name: each.value for name, each in self.state.parameters.items()}

    # -- what always holds

    @invariant()
    def a_parameter_is_busy_as_long_as_its_request_is_under_way(self):
        for parameter in self.state.parameters.values():
            assert parameter.busy == (parameter in self.under_way)
            assert parameter.busy or parameter.waiting is None

    @invariant()
    def what_is_wanted_waits(self):
        for parameter, value in self.wanted.items():
            assert parameter.waiting is not None and parameter.waiting.value == value

    # -- and in the end

    def teardown(self):
        """Let everything arrive, and each worker do what it was asked to do, and nothing else."""
        for _ in range(50):
            while self.requests:
                self.serve(0)
            while self.answers:
                self.deliver_answer(0)
            while self.events:
                self.deliver_event()
            if self.reading is None:
                self.begin_reading()
            if self.reading is not None:
                if self.result is None:
                    self.answer_reading()
                self.end_reading()
            self.show()
            self.now += 1.0
        assert self.state.is_settled
        assert self.state.read_again_in(self.now) is None
        assert (self.state.status, self.state.busy_names, self.wanted) == ('', [], {})
        assert self.shown == self.stored


TestAnyOrder = AnyOrder.TestCase
TestAnyOrder.settings = settings(max_examples=120, stateful_step_count=50)
