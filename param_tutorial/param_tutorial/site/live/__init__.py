"""Lesson pages with a node of their own.

A page is what it was: the chapter with its stored outputs, readable at once and without a script. Beside that it can
run the chapter, in the Python that `browser.page_python` gathers for JupyterLite too: Pyodide, the real rclpy on
``param_tools.rcl_in_python``, the course. Nothing else answers the reader, so there is nothing that it can't answer.

**When the site is built**, ``running`` runs each chapter in Node.js with the page's own ``kernel.js``, compares what
the cells put out with what is stored in the notebook, and notes the states of the widgets that each cell shows.
``stills`` draws these states as HTML: the first picture. ``site`` puts all together.

**The Python comes as a script** (``python_files``), Pyodide and all packages, packed by xz as one and written as text,
because a page on a disk can load scripts and nothing else. Over the web the same script serves. So a page never
fetches, and its content-security policy forbids it to: `connect-src` names no server, not even its own, and a worker
made from memory inherits that. Of the HTML that a cell puts out, DOMPurify leaves nothing that runs a script or leaves
the page by itself; of the scripts that widgets bring, only those run that the site was built with. So code in a cell
reaches no other machine, unless the reader clicks a link that it shows. It can read and change what this browser keeps
for the site.

**In the page** there are three layers, and the first two are the same in Node.js as in a browser:

- ``kernel.js`` runs cells and says what they put out and what becomes of their widgets. Widgets go by names such as
  ``cell-04/1/10`` (cell, run, number) in place of random ids, so that the states noted at the build and those of the
  reader's kernel are about the same widgets.
- ``worker.js`` begins Pyodide and is the kernel's thread. Before that another worker of this script unpacks, and its
  memory is free when it ends. Reading is never held up. Both are classic workers, for Chromium lets a page on a disk
  have no worker that is a module.
- ``page.js`` knows the cells. The kernel begins when something is touched, edited or run. What is touched first may
  be in the middle: the cells above run then, as "Run All Above" does, with what the reader has typed into them. A
  cell's outputs are drawn anew only if their digest isn't the one noted at the build.

**A view is one thing from the first picture on** (``widgets.js``). The front ends of JupyterLab (anywidget's
`render({model, el})`) draw the noted states at once. What a hand does before the kernel has the widget waits in the
view's handle; when its cell has run, the same handles become the kernel's widgets, and what waits is told to them.
Nothing is drawn twice, and a drag goes on under the hand. In a wide window robots and panels stand beside the section
that is about them (``margin.js``), and their places in the text have a button. Of ipywidgets themselves boxes, HTML and
sliders are drawn: the predictions, which use others, are forms of the page.

**What the reader types is kept** in the browser (``kept_code.js``), and so is what is solved and predicted
(``scripts/progress.js``); the kernel gets that as the file that the course keeps in a checkout. Values that are set are
gone when the page is loaded again, as they are when a notebook's kernel restarts. The files of the reader's own package
are those of JupyterLab in the browser: the worker tells of each change at once (``followed_files.js``), and the page
writes it into the records of JupyterLite's drive, where every kernel that starts later finds it (``kept_files.js``).
"""
