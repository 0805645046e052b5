"""Predictions of chapter 8."""

from param_tutorial.exercises.prediction import Prediction

SOLVED = ''

PREDICTIONS: tuple[Prediction, ...] = ()
