"""The pages of the website: how chapters are drawn, and written by Sphinx.

chapter       a chapter as a source for Sphinx
predictions   predictions as forms
links         a chapter's links, led to where the site has what they mean
front_page    the first page of the site
drawing       small pieces of HTML that several pages have
writing       lets Sphinx write pages
inlining      one page as one file
"""
