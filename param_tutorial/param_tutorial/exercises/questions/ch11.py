"""Predictions of chapter 11."""

from param_tutorial.exercises.prediction import Prediction

SOLVED = ''

PREDICTIONS: tuple[Prediction, ...] = ()
