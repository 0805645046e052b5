"""The chapters as a website that is alive without a kernel: ``python -m param_tutorial.lessons``, or ``make html``.

    build       what happens, in which order; the site is replaced as a whole or not at all
    run         runs a chapter in kernels of its own, compares its outputs, has its widgets recorded
    recorder    inside such a kernel: asks the node what a reader may ask it, and writes the answers down
    drawing     recordings as accessible HTML
    chapter     a chapter with its recordings as a source for Sphinx
    single      one page of the site as one file
    site/       Sphinx's configuration, the site's style and script

Sphinx, myst-nb and the theme are in the extra ``html`` of pyproject.toml; ``recorder`` does without them.
"""
