"""For each exercise the wrong answers that people give, one module for each chapter.

{exercise: [(replacements, count, word), …]}: what is replaced in the solution, how many requirements are still met,
and a word that the check has to find.
"""

from wrong_answers import (
    ch01,
    ch02,
    ch03,
    ch04,
    ch05_1,
    ch05_2,
    ch05_3,
    ch06,
    ch07_1,
    ch07_2,
    ch07_3,
    ch08,
    ch09,
    ch10_1,
    ch10_2,
    ch10_3,
    ch10_4,
    ch11,
)

_CHAPTERS = (ch01, ch02, ch03, ch04, ch05_1, ch05_2, ch05_3, ch06, ch07_1, ch07_2, ch07_3, ch08, ch09, ch10_1, ch10_2,
             ch10_3, ch10_4, ch11)
WRONG = {number: cases for module in _CHAPTERS for number, cases in module.WRONG.items()}
