"""Stands in a page for JupyterLite's piplite, with which ``%pip`` fetches packages: these pages have no network.

The kernel's worker asks for these two modules by name. The real ones take a tenth of the time that a kernel needs to
start.
"""
