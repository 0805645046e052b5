"""For teachers: what a class has solved, what to talk about next, and a plan for each lesson.

    classroom         the progress files of a class, and the table of students and chapters
    misconceptions    which wrong answers a class has given, and which requirements it misses
    page              the same as a page for a browser, in the class's folder
    plan              a chapter's sections with their minutes, its questions, and the mistakes that they test
    command           ``python -m param_tutorial.teacher``

Everything is read from the chapters, from the questions and exercises, and from the files of the class. Nothing is sent
anywhere: the page with the students' names is a file in the teacher's own folder.
"""
