"""The parameters of one node: a client, its live state, rules, locks, aliases. No Jupyter."""
