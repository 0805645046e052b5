"""What a notebook adds to Python: magics, a shell, terminals beside it, the glossary of all chapters, its words
where they stand in the text, the veil.
"""
