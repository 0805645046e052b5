"""The parameters of running nodes and in files: client, sets, systems, checks, logs, rules, aliases. No Jupyter."""
