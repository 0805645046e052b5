"""The predictions, one module for each chapter, beside its exercises in ``chapters``. No module imports another.

Each has RECALLS, its questions about earlier chapters; PREDICTIONS; and SOLVED, what a learner reads who has solved all
its exercises.
"""
