"""Exercises of chapter 6.1: the driver's brakes as a parameter, descriptors to write, and two that are ignored."""

from param_tools.node.client import ParameterClient
from param_tools.values import DOUBLE, INTEGER
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_accepted,
    expect_answers,
    expect_declared,
    expect_no_start,
    expect_range,
    expect_range_fields,
    expect_rejected,
    take_type_for_granted,
)
from param_tutorial.exercises.steps import DRIVER, expect_speed, start_on_bench
from param_tutorial.exercises.trial import Trial, expect, overrides

CHAPTER = '06_1_descriptors_and_ranges'
FIELDS = 'Eight fields'
DOUBLES = 'When are two doubles equal?'
IGNORED = 'A range that nobody enforces'
SHARED = 'One descriptor for two'
SPEED, STOP, BRAKING = 'max_speed_mps', 'stop_distance_m', 'braking_mps2'


def start(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter whose range has fields of the right types."""
    node = trial.start()
    expect(node.has_parameter(name), f'a parameter `{name}`', 'the node has none of that name')
    expect_range_fields(node, name)
    return trial.client(node)


def expect_own_descriptor(trial: Trial, *names: str) -> None:
    """Expect each of some parameters, as far as the learner's node has them, to have a descriptor of its own."""
    node = trial.start()
    for name in filter(node.has_parameter, names):
        found = node.describe_parameter(name).name
        expect(found == name, f'the descriptor of `{name}` names `{name}`',
               f'it names `{found}`: a later declaration has overwritten it')


def expect_described(trial: Trial, *names: str) -> None:
    """Expect each of some parameters to have a description."""
    node = trial.start()
    for name in names:
        expect(node.has_parameter(name), f'a parameter `{name}`', 'the node has none of that name')
        expect(node.describe_parameter(name).description.strip().strip('.…'), 'a description for each',
               f'`{name}` has none')


brakes = Exercise('6.1a', 'Brakes as a parameter', CHAPTER, DRIVER, node_name='driver', hints=(
    'The third declaration looks like the other two, with another range: '
    '`FloatingPointRange(from_value=0.1, to_value=3.0, step=0.1)`. Give it a descriptor of its own.',
    "The judge gets the third value as it gets the other two, with `new.get('braking_mps2', ...)`, and divides by it. "
    'The list of names from which the constructor takes the start values gets the third name.',
    'A text can be shared. Write `RULE = ...` above the class, and `additional_constraints=RULE` in all three '
    'descriptors.'))


@brakes.require('`braking_mps2` is a double, 1.0 at the start, from 0.1 to 3.0 in steps of 0.1, with a description',
                see=FIELDS)
def declares_brakes(trial: Trial) -> None:
    expect_declared(trial, BRAKING, DOUBLE, 1.0)
    expect_range(start(trial, BRAKING), BRAKING, 0.1, 3.0, 0.1)
    expect_described(trial, BRAKING)


_WHICH = '. What counts for the brakes is the request, and if they are not in it, what is stored at that moment'


@brakes.require('the judge takes it from the request, or else from what is stored, and judges the start, too',
                see=FIELDS)
def judges_brakes(trial: Trial) -> None:
    driver = trial.start()
    take_type_for_granted(trial.client(driver), DOUBLE, SPEED, STOP, BRAKING)
    for new, is_good in (({BRAKING: 3.0}, True), ({SPEED: 1.2}, True), ({BRAKING: 1.0}, False),
                         ({SPEED: 0.5, BRAKING: 0.5}, True), ({SPEED: 0.8}, False),
                         ({BRAKING: 1.0, SPEED: 0.8}, True), ({BRAKING: 0.1}, False),
                         ({STOP: 5.0, BRAKING: 0.1}, True)):
        (expect_accepted if is_good else expect_rejected)(trial, driver, new, _WHICH)
    trial.start(ros_args=overrides({SPEED: 1.2, BRAKING: 3.0}))
    for start in ({BRAKING: 0.2}, {SPEED: 2.0}):
        words = overrides(start)
        expect_no_start(trial, words, 'no start with ' + ' '.join(words), 'it started, with too little room to brake')


@brakes.require('`additional_constraints` of all three parameters tells the rule, with the names of the three',
                see=FIELDS)
def tells_rule(trial: Trial) -> None:
    node, names = trial.start(), (SPEED, STOP, BRAKING)
    expect(node.has_parameter(BRAKING), f'a parameter `{BRAKING}`', 'the node has none of that name')
    expect_own_descriptor(trial, *names)
    for name in names:
        text = node.describe_parameter(name).additional_constraints
        missing = [f'`{each}`' for each in names if each not in text]
        expect(not missing, f'`additional_constraints` of `{name}` names the three',
               f'it is `{text}`, without {", ".join(missing)}' if text else 'it is empty')


@brakes.require('it drives and logs as before', see=FIELDS)
def goes_on(trial: Trial) -> None:
    heard: list[str] = []
    stop_listening = trial.ros.node_log.on_line(lambda line: heard.append(line.text))
    try:
        driver, bench = start_on_bench(trial)
        expect_accepted(trial, driver, {SPEED: 0.75})
        expect_speed(trial, bench, 0.75, 'once `max_speed_mps = 0.75` is stored')
        wanted = f'{SPEED} is now 0.75'
        trial.wait(lambda: any(wanted in each for each in list(heard)), f'`{wanted}` in the log',
                   lambda: 'it logs no such line')
        bench.measure(0.3)
        expect_speed(trial, bench, 0.0, '0.3 m before the wall')
    finally:
        stop_listening()


describe = Exercise('6.1b', 'Say it in the descriptor', CHAPTER, NODE_CLASS, node_name='camera', hints=(
    'Each parameter needs one `ParameterDescriptor`. Begin with `exposure_us`, and try a value: '
    "`ParameterClient(ros.add(Camera)).set_parameter('exposure_us', 150)`.",
    'The fields are `integer_range` and `floating_point_range`. The range stands in brackets, and each of the two '
    'fields belongs to one type of default.',
    'For the second parameter: `ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=-90.0, '
    'to_value=90.0, step=0.5)])`, and a description.'))


@describe.require('`exposure_us` is an integer, 500, and takes 100, 200, 300 and so on up to 10000', see=FIELDS)
def exposure(trial: Trial) -> None:
    client = start(trial, 'exposure_us')
    expect_declared(trial, 'exposure_us', INTEGER, 500)
    expect_answers(client, 'exposure_us', 'accepted', 100, 200, 300, 700, 9900, 10000)
    expect_answers(client, 'exposure_us', 'out of range', 0, 10100, 99, 10001,
                   because='The limits of an integer are the two ends of its `integer_range`')
    expect_answers(client, 'exposure_us', 'off the step', 101, 150, 9999,
                   because='The step is the third field of `IntegerRange`')
    expect_answers(client, 'exposure_us', 'wrong type', 200.0)
    expect_range(client, 'exposure_us', 100, 10000, 100)


@describe.require('`tilt_deg` is a double, 0.0, and takes every half degree from -90.0 to 90.0', see=DOUBLES)
def tilt(trial: Trial) -> None:
    client = start(trial, 'tilt_deg')
    expect_declared(trial, 'tilt_deg', DOUBLE, 0.0)
    expect_answers(client, 'tilt_deg', 'accepted', -90.0, -0.5, 0.0, 12.5, 90.0)
    expect_answers(client, 'tilt_deg', 'out of range', -90.5, 91.0,
                   because='The limits of a double are the two ends of its `floating_point_range`')
    expect_answers(client, 'tilt_deg', 'off the step', 0.25, 12.3,
                   because='The step is the third field of `FloatingPointRange`')
    expect_answers(client, 'tilt_deg', 'wrong type', 2)
    expect_range(client, 'tilt_deg', -90.0, 90.0, 0.5)


@describe.require('each of the two has a description', see=FIELDS)
def described(trial: Trial) -> None:
    expect_described(trial, 'exposure_us', 'tilt_deg')


mend = Exercise('6.1c', 'Fix two silent faults', CHAPTER, NODE_CLASS, node_name='winch', hints=(
    'Ask the winch as it is: `ParameterClient(ros.add(Winch)).describe_parameters()`. Compare what it says with what '
    'is declared.',
    'A range only counts for a default of its own kind. A descriptor serves one declaration.',
    'Write a function `meters()` that returns a new descriptor each time, and give the default its dot.'))


@mend.require('`rope_m` starts at 10.0 and `hook_m` at 0.0, and both take every double from 0.0 to 30.0', see=IGNORED)
def limits(trial: Trial) -> None:
    for name, value in (('rope_m', 10.0), ('hook_m', 0.0)):
        client = start(trial, name)
        expect_declared(trial, name, DOUBLE, value)
        expect_answers(client, name, 'accepted', 0.0, 0.001, 12.34, 30.0)
        expect_answers(client, name, 'out of range', -0.001, 30.001,
                       because='Does it have a range of doubles, with these two ends?')
        expect_answers(client, name, 'wrong type', 20)
        expect_range(client, name, 0.0, 30.0, 0)


@mend.require('each of the two has a descriptor of its own', see=SHARED)
def own_descriptors(trial: Trial) -> None:
    expect_own_descriptor(trial, 'rope_m', 'hook_m')


EXERCISES = (brakes, describe, mend)
