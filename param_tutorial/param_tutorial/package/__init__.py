"""The reader's own package on the stage: its node, what its file lacks, its editor.

    package      ``Package``, which chapters work with
    robot        the robot that the nodes drive, to be seen
    editor       a file in the notebook or the page, to change and save
    following    the robot's base on the stage, and beside it the nodes of the files
    loading      a file of the reader's as a class of nodes

How a saved file becomes the node. A cell saves it, the editor, or another program: ``following`` sees that its text
has changed: after each cell, and twice a second. It runs the file as an import does, and puts the class of nodes
in it on the stage, in the place of the one before. If that fails, the one before starts again.
"""
