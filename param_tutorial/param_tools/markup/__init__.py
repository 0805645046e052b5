"""Text for a page or a terminal: tables, style sheets, numbers with their nouns. No ROS, no Jupyter."""
