"""The course without a machine of its own: the Python of a web page, and JupyterLab in the browser on top of it."""
