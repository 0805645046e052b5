"""The first page of the site: a robot to try at once, the chapters, and what the lessons ran on."""

import html
import re
from collections.abc import Mapping
from pathlib import Path

import nbformat

from param_tools.markup.tables import with_code
from param_tutorial.site.live.running import LiveChapter
from param_tutorial.site.live.stills import still
from param_tutorial.site.pages.chapter import COURSE, NO_SCRIPT, live_cells
from param_tutorial.site.pages.links import LAB, Links, is_deeper

_ROW = re.compile(r'\| *([\d.]+) *\| *\[([^]]+)\]\((\w+)\.ipynb\) *\| *([^|]+?) *\| *(\d+(?: \+ \d+)?) *\|'
                  r'(?: *([^|\n]+?) *\|)?')

_TEXT = '''# Mastering ROS 2 Parameters with Python

<p class="front-lead">A robot's behavior depends on numbers: how fast, how far, how careful. In ROS 2 they are
<em>parameters</em>, and you can change them while the robot runs.</p>

{no_script}

{try_it}

{doors}

## The lessons

Each lesson asks one question and lets a real ROS 2 Jazzy node answer it. Everything it says, it shows.

<p class="lesson-progress" hidden></p>

{chapters}

{deeper}## How to read them

**Here, without installing anything.** A node runs in each page: rclpy, ROS's own code for Python, on Python in the
browser, without a network. Change any value, and edit and run any cell; exercises are checked. What you do is kept in
this browser and nowhere else.

{in_lab}**On a Linux machine with Python.** The course brings a panel, a terminal and the real ROS 2 with it; you don't
need to install ROS. [How to get and start it](at_home.md).

## When they ran

{provenance}

```{{toctree}}
:hidden:

{names}
```
{more_names}'''

_DOORS = '''<ul class="front-doors">
<li><b>You are new to ROS</b><p>In five lessons you write the program that drives this robot. You need four hours, and
Python.</p><p><a href="{one}.html">Start with lesson 1</a></p></li>
<li><b>You have a node to fix</b><p>It <a href="{six}.html">rejects a value</a>, it <a href="{seven}.html">starts with
the wrong one</a>, or it <a href="{five}.html">hangs</a>: each is one lesson.</p></li>
<li><b>You teach</b><p>Each lesson names the lessons before it, and its exercises check themselves.</p>
<p><a href="at_home.html">Teach with it</a></p></li>
</ul>'''

# Commands are for those who have a terminal, so they have a page to themselves.
_AT_HOME = f'''---
orphan: true
---
# On your own machine, and with a class

**How do you start the course on Linux, and see how a class is doing?**

1. <a href="{COURSE}.zip" download>Download the course</a>, and unpack it. You need Linux, and Python 3.10 or newer.
2. Type `make lab` in its folder. The first time, it sets up Python and ROS 2 there, and changes nothing else.
3. JupyterLab opens with your own copies of the lessons.

## Which lessons to take

{{ways}}
'''

_MORE = '''
```{{toctree}}
:caption: Deeper
:hidden:

{}
```
'''

_IN_LAB = f'''**In JupyterLab, in this browser.**
<a href="{LAB}/lab/index.html?path=index.md">Open the lab</a>: the same
lessons as notebooks, about 50 MB, once; there is nothing to install. What you change stays in this browser.
<a href="{LAB}/LICENSES.md">Its licenses</a>.

'''


def front_page_source(index: Path, chapters: Mapping[Path, LiveChapter], facts: dict[str, str], *,
                      has_lab: bool = False) -> str:
    """Return the first page, as Markdown.

    :param index: The start page of the notebooks, whose table names the chapters.
    :param chapters: As the kernels of their pages ran them.
    :param facts: From which state of the course the lessons ran, and on what; see ``archive.provenance``.
    :param has_lab: True if JupyterLab for the browser is a part of the site.
    """
    names = [path.stem for path in chapters if not is_deeper(path)]
    deeper = [path.stem for path in chapters if is_deeper(path)]
    # There, all but the first five chapters is folded.
    text = re.sub(r'</?details>\n|<summary>.*</summary>\n', '', index.read_text(encoding='utf-8') + '\n')
    links = Links(index, nbformat.v4.new_notebook(), {*names, *deeper, 'claims'})
    return _TEXT.format(no_script=NO_SCRIPT, try_it=_robot_to_try(chapters), doors=_doors(text, names),
                        chapters=_groups(text, names), provenance=_provenance_text(facts),
                        deeper=f'## Deeper\n\n{_section(links.in_markdown(text), "Deeper")}\n\n' if deeper else '',
                        in_lab=_IN_LAB if has_lab else '', names='\n'.join(names),
                        more_names=_MORE.format('\n'.join(deeper)) if deeper else '')


def _robot_to_try(chapters: Mapping[Path, LiveChapter]) -> str:
    """Return a robot and its panel, alive, if a chapter begins with them."""
    for path, live in chapters.items():
        for at, cell in enumerate(live.cells):
            shown = ''.join(state.get('markup', '') for state in cell.states.values())
            if 'robot-picture' in shown and 'param-row' in shown:
                # The page runs the cells down to this one, and shows none but this.
                markup = (f'{live_cells(live.cells[:at + 1])}<div class="front-robot cell tag_live-{cell.id}">'
                          f'<div class="cell_output">{still(cell, cell.roots[0])}</div></div>')
                # A block of HTML in Markdown ends at an empty line.
                markup = re.sub(r'\n\s*\n', '\n', markup)
                return (f'```{{raw}} html\n{markup}\n```\n\n'
                        'Move the slider while the robot drives. How fast may it be, and still stop before the wall? '
                        f'That is where [the first lesson]({path.name}) begins.')
    return ''


def _section(text: str, heading: str) -> str:
    """Return what stands below a heading of the notebooks' start page; nothing if it has no such heading."""
    found = re.search(rf'^## {heading}\n(.*?)(?=^## |\Z)', text, re.DOTALL | re.MULTILINE)
    return found[1].strip() if found else ''


def _doors(text: str, names: list[str]) -> str:
    """Return three doors for three readers, if the chapters that they lead to are there."""
    by_number = {number: name for number, _, name, *_ in _ROW.findall(text) if name in names}
    numbers = {'one': '1', 'five': '5.4', 'six': '6.1', 'seven': '7.3'}
    if not by_number.keys() >= set(numbers.values()):
        return ''
    return _DOORS.format(**{word: by_number[number] for word, number in numbers.items()})


def at_home_source(index: Path, pages: set[str]) -> str:
    """Return the page about the course on one's own machine and in a class, as Markdown.

    :param index: The start page of the notebooks, whose table says where to start.
    :param pages: The names, without ending, of all pages of the site.
    """
    links = Links(index, nbformat.v4.new_notebook(), pages)
    section = _section(index.read_text(encoding='utf-8'), 'Where to start')
    return _AT_HOME.format(ways='\n'.join(re.findall(r'^\|.*', links.in_markdown(section), re.MULTILINE)))


def _groups(text: str, names: list[str]) -> str:
    """Return the chapters in the groups of the notebooks' start page."""
    groups = []
    for group in re.split(r'^(?=### )', _section(text, 'Chapters') or text, flags=re.MULTILINE):
        if cards := _cards(group, names):
            words = re.sub(r'^\|.*$', '', group, flags=re.MULTILINE).strip() if group.startswith('### ') else ''
            groups.append(f'{words}\n\n{cards}'.strip())
    return '\n\n'.join(groups)


def _cards(text: str, names: list[str]) -> str:
    cards = ''.join(
        f'<li><a href="{name}.html"><span class="front-number">{number}</span> {html.escape(title)}</a>'
        f'<p>{html.escape(question)}</p>'
        + (f'<p class="front-after">Afterwards you can {with_code(after)}.</p>' if after else '')
        + f'<p class="front-minutes">{minutes} minutes</p></li>'
        for number, title, name, question, minutes, after in _ROW.findall(text) if name in names)
    return cards and f'<ul class="front-lessons">{cards}</ul>'


def _provenance_text(facts: dict[str, str]) -> str:
    ran = f'on Python {facts["Python"]} with rclpy {facts["rclpy"]} of ROS 2 Jazzy'
    if 'commit' not in facts:
        return f'The lessons of this site ran {ran}. Every output was compared with the one stored in its notebook.'
    state = f'as of {facts["date"]} (`{facts["commit"]}`{" " + facts["changed"] if facts["changed"] else ""})'
    return (f'The lessons of this site ran from start to end {state}, {ran}. Every output was compared with the one '
            f'stored in its notebook; a difference would have stopped the build.')
