"""The predictions, one module for each chapter, beside its exercises in ``chapters``. No module imports another."""

from param_tutorial.exercises.questions import (
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

# For each chapter its questions about earlier ones, its predictions, and what is said to whoever has solved all its
# exercises.
QUESTIONS = tuple((module.RECALLS, module.PREDICTIONS, module.SOLVED) for module in (
    ch01, ch02, ch03, ch04, ch05_1, ch05_2, ch05_3, ch06, ch07_1, ch07_2, ch07_3, ch08, ch09, ch10_1, ch10_2, ch10_3,
    ch10_4, ch11))
