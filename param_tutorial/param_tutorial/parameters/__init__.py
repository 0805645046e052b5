"""The parameters of running nodes and in files: values, client, sets, systems, checks, logs, rules, aliases. No Jupyter."""
