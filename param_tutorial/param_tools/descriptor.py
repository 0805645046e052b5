"""What is known of one parameter: type, range, description, who may change it. No ROS: ``node.client`` asks for it."""

from dataclasses import dataclass

from param_tools.values import ParameterType


@dataclass(frozen=True)
class Range:
    """The values that a number may take. Both ends are always valid, even off the step."""

    from_value: float
    to_value: float
    step: float
    """Distance of valid values, counted from from_value; 0 for any."""


@dataclass(frozen=True)
class Descriptor:
    """What a node tells about one of its parameters."""

    name: str
    type: ParameterType
    description: str = ''
    additional_constraints: str = ''
    """Text for people; no node enforces it."""
    read_only: bool = False
    dynamic_typing: bool = False
    range: Range | None = None

    @property
    def rules(self) -> list[str]:
        """What the node enforces, in words: the range, and whether the value or its type is free."""
        words = []
        if self.range:
            words.append(f'{self.range.from_value} to {self.range.to_value}'
                         + (f' in steps of {self.range.step}' if self.range.step else ''))
        return words + ['read only'] * self.read_only + ['any type'] * self.dynamic_typing

    def __repr__(self) -> str:
        facts = [self.type.label, *self.rules]
        facts += [text for text in (self.additional_constraints, self.description) if text]
        return f'{self.name}: ' + '; '.join(facts)


class Descriptors(dict[str, Descriptor]):
    """Parameter names and their Descriptor; shown one to a line."""

    def __repr__(self) -> str:
        return '\n'.join(map(repr, self.values())) or '(no parameters)'


def is_housekeeping(name: str) -> bool:
    """True if this is one of the parameters that rclpy and rclcpp declare in every node."""
    return name in ('use_sim_time', 'start_type_description_service') or name.startswith('qos_overrides.')
