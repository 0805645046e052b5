"""Numbers that were given again when a chapter was divided, so that what a learner has solved before still counts."""

# What was solved or predicted as the first proves the others, and nothing more: an exercise that asks for more than
# its predecessor has to be solved anew.
RENUMBERED = {
    '6a': ('6.1c', '6.2c'), '6b': ('6.2a',), '6c': ('6.1b',),
    '6-1': ('6.1-1',), '6-2': ('6.1-2',), '6-3': ('6.1-3',), '6-4': ('6.1-5',), '6-7': ('6.1-7',),
    '6-5': ('6.2-1',), '6-6': ('6.2-2',), '6-8': ('6.2-5',),
    '6-r1': ('6.1-r1',), '6-r2': ('6.1-r2',),
    '6': ('6.1', '6.2'),
    '9a': ('9.1c',), '9b': ('9.2b',), '9c': ('9.1a',),
    '9-1': ('9.2-1',), '9-2': ('9.2-2',), '9-3': ('9.1-4',), '9-4': ('9.2-4',), '9-5': ('9.1-7',),
    '9-r1': ('9.1-r1',), '9-r2': ('9.1-r2',),
    '9': ('9.1', '9.2'),
    '10.4c': ('10.5c',),
}
