"""What a learner has solved and predicted: one small file of the learner's own, and the ticks on the start page.

    record       the file: read, added to, set aside if it is damaged
    renumbered   the numbers that exercises had before their chapter was divided
    ticks        the start page, with a mark at each chapter
    storage      files written whole or not at all, and by one process at a time

Nothing is remembered unless ``make lab`` has named the file in an environment variable, so tests write nothing.
"""
