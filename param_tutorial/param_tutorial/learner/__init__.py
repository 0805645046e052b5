"""The learner's copies of the chapters, which ``make lab`` keeps up to date: ``python -m param_tutorial.learner``.

    command      the command line: a chapter fresh again, progress forgotten, a class as a table
    classroom    what a class has solved
    copies       the folder of the copies: what is put there, what stays, and what is kept as a backup
    merging      a changed chapter and a learner's copy become one notebook

The stored outputs of the chapters are the tests, so nobody works on the chapters themselves.
"""
