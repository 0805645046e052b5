"""What a check answers: words first, for a terminal and a screen reader, and the same words as HTML."""

import html
import textwrap
from dataclasses import dataclass

from param_tools.markup.styles import style
from param_tools.markup.tables import with_code

_WIDTH = 110
# Its colors follow the page's theme, and none says anything that no word says.
STYLE = style('param_tutorial/exercises/results.css')


class Answer:
    """A sentence or more, shown as they are."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return _wrapped(self.text)

    def _repr_html_(self) -> str:
        return f'{STYLE}<div class="param-check"><p>{with_code(self.text)}</p></div>'


@dataclass(frozen=True)
class Finding:
    """What became of one requirement."""

    sentence: str
    done: bool | None
    """None if it could not be tried."""
    expected: str = ''
    happened: str = ''
    see: str = ''
    """The section of the chapter to look at."""

    @property
    def word(self) -> str:
        """'done', 'not yet' or 'not tried'."""
        return {True: 'done', False: 'not yet', None: 'not tried'}[self.done]

    @property
    def details(self) -> dict[str, str]:
        """What helps you go on, by label; empty if there is nothing to say."""
        details = {'expected': self.expected, 'happened': self.happened, 'look at': self.see and f'“{self.see}”'}
        return {word: text for word, text in details.items() if text}


class Result(Answer):
    """The answer of a check."""

    def __init__(self, number: str, findings: list[Finding], total: int, after: str,
                 picture: str = '') -> None:
        """
        :param number: Of the exercise.
        :param findings: One for each requirement, in their order; further ones before them.
        :param total: How many requirements there are.
        :param after: What to say at the end.
        :param picture: What the work makes a node do, as HTML; the findings say in words what is to be seen.
        """
        self.findings = tuple(findings)
        self.help = ''
        """What follows in a notebook of a learner, as HTML; what is stored with the chapters has nothing here."""
        self.picture = picture
        self.done = all(finding.done for finding in findings)
        self.count = sum(finding.done is True for finding in findings)
        self.heading = f'Exercise {number}: {"done" if self.done else "not yet"}'
        self.score = f'{self.count} of {total} done'
        super().__init__(after)

    def __repr__(self) -> str:
        lines = [f'{self.heading}, {self.score}', '']
        for finding in self.findings:
            lines.append(_wrapped(f'{finding.word:<9}  {finding.sentence}', ' ' * 11))
            for word, text in finding.details.items():
                lines.append(_wrapped(f'{"":11}{word:<8}  {text}', ' ' * 21))
        return '\n'.join([*lines, '', _wrapped(self.text)])

    def _repr_html_(self) -> str:
        items = ''.join(map(markup, self.findings))
        return (f'{STYLE}<div class="param-check"><p><b>{self.heading}</b>, {self.score}</p>'
                f'{self.picture}<ul class="param-findings">{items}</ul><p>{with_code(self.text)}</p>'
                + (f'<div class="param-hints">{self.help}</div>' if self.help else '') + '</div>')


def anchor(heading: str) -> str:
    """Return the name by which JupyterLab, and so a chapter's links, know a heading."""
    return heading.strip().replace(' ', '-')


def _section_link(section: str) -> str:
    return f'<a href="#{html.escape(anchor(section.strip("“”").replace("`", "")))}">{with_code(section)}</a>'


def markup(finding: Finding) -> str:
    """Return what became of a requirement, as an item of a list in HTML."""
    details = ''.join(f'<dt>{word}</dt><dd>{_section_link(text) if word == "look at" else with_code(text)}</dd>'
                      for word, text in finding.details.items())
    return (f'<li class="param-{finding.word.replace(" ", "-")}"><b>{finding.word}</b> · {with_code(finding.sentence)}'
            + (f'<dl>{details}</dl>' if details else '') + '</li>')


def _wrapped(text: str, indent: str = '') -> str:
    return textwrap.fill(text, _WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
