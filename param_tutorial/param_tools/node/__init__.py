"""The parameters of one node: a client, its live state, rules, locks. No Jupyter."""
