"""Conditions: whether an action of a launch file is carried out."""

from typing import Any

from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.substitutions import TRUTH, expect_string, perform


class Condition:
    """Decides whether an action is carried out."""

    def evaluate(self, context: Context) -> bool:
        """Return whether it is."""
        raise NotImplementedError


class IfCondition(Condition):
    """True if a string is true or 1, false if it is false or 0."""

    def __init__(self, predicate_expression: Any):
        expect_string(predicate_expression)
        self.predicate_expression = predicate_expression

    def evaluate(self, context: Context) -> bool:
        text = perform(self.predicate_expression, context)
        found = TRUTH.get(text.strip().lower())
        if found is None:
            raise LaunchFailed(f"a condition expands to '{text}', and must be one of true, 1, false, 0")
        return found


class UnlessCondition(IfCondition):
    """The opposite of IfCondition."""

    def evaluate(self, context: Context) -> bool:
        return not super().evaluate(context)


class LaunchConfigurationEquals(Condition):
    """True if an argument has a value; with None, if it is not set."""

    def __init__(self, launch_configuration_name: str, expected_value: Any):
        self.name = launch_configuration_name
        self.expected_value = expected_value

    def evaluate(self, context: Context) -> bool:
        wanted = None if self.expected_value is None else perform(self.expected_value, context)
        return bool(context.launch_configurations.get(self.name) == wanted)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """The opposite of LaunchConfigurationEquals."""

    def evaluate(self, context: Context) -> bool:
        return not super().evaluate(context)
