"""Predictions of chapter 9."""

from param_tutorial.exercises.prediction import Prediction

SOLVED = ''

PREDICTIONS: tuple[Prediction, ...] = ()
