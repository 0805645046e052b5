"""The parameters of one node: a client and its live state. No Jupyter."""
