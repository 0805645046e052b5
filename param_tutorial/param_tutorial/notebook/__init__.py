"""What a notebook adds to Python: magics, a shell, terminals beside the notebook, the glossary of all chapters."""
