"""Recordings as pages: how they are drawn, and written by Sphinx.

A recording depends on nothing in here.

    drawing       recordings as accessible HTML
    chapter       a chapter with its recordings as a source for Sphinx
    links         a chapter's links, led to where the site has what they mean
    front_page    the first page of the site
    writing       lets Sphinx write pages
    search_index  the sections of all pages, for the site's search
    inlining      one page as one file
"""
