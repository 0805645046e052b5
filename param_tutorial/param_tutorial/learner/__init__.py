"""The learner's files: copies of the chapters, and what has been solved. No ROS.

    copies       the folder of the copies: what ``make lab`` puts there, and what stays
    progress     the file that remembers what a learner has solved and predicted
    ticks        the start page, with a mark at each chapter
    __main__     ``make reset``: a chapter fresh again
    package_files  the files of the reader's package, and ours after each step of the course
    finished     ``make robot``: the package with which a reader ends
    syllabus     what there is to solve in each chapter
    storage      files written whole or not at all, and by one process at a time

The stored outputs of the chapters are the tests, so nobody works on the chapters themselves.
"""
