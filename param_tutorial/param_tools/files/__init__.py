"""Parameter files, and descriptions of what nodes declare: read, checked, written, edited. PyYAML alone, no ROS."""
