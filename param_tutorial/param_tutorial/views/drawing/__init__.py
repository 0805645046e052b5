"""What the views show, as SVG and HTML: data in, text out. Nothing here imports ROS or Jupyter.

Each view has its drawing in the file of the same name. All of them draw with the strokes, boxes, words and animations
of ``svg``.
"""
