"""For teachers: what a class has solved, which wrong answers it has given, and where it is stuck.

    classroom         the progress files of a class, and the table of students and chapters
    misconceptions    which wrong answers a class has given, and which requirements it misses
    __main__          ``python -m param_tutorial.teacher``: prints both

Everything is read from the questions and exercises, and from the files of the class. Nothing is sent anywhere.
"""
