"""The chapters as a website that is alive without a kernel: ``python -m param_tutorial.site``, or ``make html``.

    command      the command line
    build        what happens, in which order; the site is replaced as a whole or not at all
    single       one chapter of the site as one file
    archive      the recordings of all chapters, of which those that have not changed are kept
    recording/   runs a chapter, compares its outputs, asks its views and nodes what a reader may ask
    workers      the processes in which chapters are recorded; none outlives the build
    pages/       recordings as pages, written by Sphinx
    site/        Sphinx's configuration, the site's style and script

Sphinx, myst-nb and the theme are in the extra ``html`` of pyproject.toml; ``recording`` does without them.
"""
