"""For each exercise the wrong answers that people give, one module for each chapter.

{exercise: [(replacements, count, word), …]}: what is replaced in the solution, how many requirements are still met,
and a word that the check has to find. No two assert the same finding. The first ones of an exercise, as many as it has
requirements, are one for each requirement that has any: `make test` tries them, and `make test-rare` all.

RIGHT has answers that do what is asked in an unusual way: {exercise: [replacements, …]}.
"""

import re
from importlib import import_module

from param_tutorial.exercises import CHAPTERS

# As a chapter's exercises, so its wrong answers: param_tutorial.exercises.ch08 and wrong_answers.ch08.
_MODULES = [import_module(f'{__name__}.ch{re.match("[0-9]+(_[0-9])?(?=_)", chapter.name)[0]}')
            for chapter in CHAPTERS.values()]
WRONG = {number: cases for module in _MODULES for number, cases in module.WRONG.items()}
RIGHT = {number: cases for module in _MODULES for number, cases in getattr(module, 'RIGHT', {}).items()}
