"""What a notebook adds to Python: magics, a shell, terminals beside it, the glossary of all chapters, the veil."""
