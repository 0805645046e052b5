"""Numbers that were given again when a chapter was divided, so that what a learner has solved before still counts."""

# What was solved or predicted as the first proves the others, and nothing more: an exercise that asks for more than
# its predecessor has to be solved anew.
RENUMBERED = {
    '10.4c': ('10.5c',),
}
