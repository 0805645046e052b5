"""Predictions of chapter 7.3."""

from param_tutorial.exercises.prediction import Prediction

SOLVED = ''

PREDICTIONS: tuple[Prediction, ...] = ()
