"""Chapters run, compared and recorded: everything that a recording depends on, and nothing that a page's looks do.

In this process:

    run           runs a chapter in kernels of its own, compares its outputs, has its views recorded
    comparison    nbval's comparison of a cell's outputs with the stored ones

Inside the chapter's kernel, without Sphinx:

    recorder      finds a view by its model's id, and records it
    interview     asks the node behind a view's controls all that a reader may ask
    dependence    finds out which answers depend on other parameters, and records those again
    album         pictures and films of the node, one for each combination that hands choose, packed
    asking        one question, and giving the node back what it had
    questions     what hands type
    taps          what a node logged, and what it published on /parameter_events

    answers       what an exercise's check says to all that a page's form lets a reader answer

And ``recorded``: what all of that brings home.
"""
