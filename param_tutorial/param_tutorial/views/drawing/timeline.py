"""A change on its way through a node, as ``set_recorder`` has recorded it, from top to bottom."""

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Step:
    """One moment of a change."""

    what: str
    """In a word or two, e.g. 'on-set'."""
    happened: str
    """As a sentence, e.g. 'validate: sees 300, accepts'."""
    stored: str
    """The value that the parameter had at this moment."""
    comes_from: str = ''
    """Who sent a message to the node; empty if nobody did."""
    goes_to: str = ''
    """To whom the node sent a message; empty if to nobody."""
    who: str = ''
    """The callback that was called; empty if none was."""
    proposed: str = ''
    """The value on its way when the moment is over; empty if it does not change."""
    objection: str = ''
    """Why the value gets no further, e.g. the callback's reason; empty if it does."""


class Timeline:
    """The steps of one change from top to bottom: what happened, and what was stored at that moment. Shown as text."""

    def __init__(self, node: str, name: str, steps: Iterable[Step]) -> None:
        """
        :param node: The node that was asked.
        :param name: The parameter that was to change.
        """
        self.node, self.name, self.steps = node, name, tuple(steps)

    def __repr__(self) -> str:
        what = max(len(step.what) for step in self.steps)
        happened = max(len(step.happened) for step in self.steps)
        heading = f'{self.node}: {self.name}'
        return '\n'.join([f'{heading:<{what + happened + 4}}  stored', *(
            f'  {step.what:<{what}}  {step.happened:<{happened}}  {step.stored}' for step in self.steps)])
