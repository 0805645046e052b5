"""For each exercise the wrong answers that people give, one module for each chapter.

{exercise: [(replacements, count, word), …]}: what is replaced in the solution, how many requirements are still met,
and a word that the check has to find.
"""

from wrong_answers import ch03, ch04, ch05_1, ch05_2, ch05_3, ch08, ch10_3

WRONG = {number: cases for module in (ch03, ch04, ch05_1, ch05_2, ch05_3, ch08, ch10_3)
         for number, cases in module.WRONG.items()}
