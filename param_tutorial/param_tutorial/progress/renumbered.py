"""Numbers that were given again when a chapter was divided, so that what a learner has solved before still counts."""

# What was solved or predicted as the first proves the others, and nothing more: an exercise that asks for more than
# its predecessor has to be solved anew.
RENUMBERED = {
    '9a': ('9.1c',), '9b': ('9.2b',), '9c': ('9.1a',),
    '9-1': ('9.2-1',), '9-2': ('9.2-2',), '9-3': ('9.1-4',), '9-4': ('9.2-4',), '9-5': ('9.1-7',),
    '9-r1': ('9.1-r1',), '9-r2': ('9.1-r2',),
    '9': ('9.1', '9.2'),
}
