"""The parameters of running nodes and in files: values, client, sets, rules, aliases. No Jupyter."""
