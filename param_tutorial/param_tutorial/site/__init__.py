"""The chapters as a website with a node in each page: ``python -m param_tutorial.site``, or ``make html``.

    build        what happens, in which order; the site is replaced as a whole or not at all
    single       one chapter of the site as one file
    archive      which state of the course the site is made of, and the course as an archive
    bundling     a script with all that it imports
    comparison   a cell's outputs beside the stored ones
    live/        the kernel of a page: runs the chapters when the site is built, and for the reader in the page
    pages/       chapters as pages, written by Sphinx
    scripts/     what a page does beside running cells: predictions and progress
    browser/     the Python of a page, and JupyterLite
    theme/       Sphinx's configuration, and the site's style

Sphinx, myst-nb and the theme are in the extra ``html`` of pyproject.toml.
"""
