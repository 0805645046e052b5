"""The parameter panel: controls in a notebook, or on a page of its own, for the parameters of any node."""
