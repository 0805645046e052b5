"""Pictures and pieces of HTML: data in, text out. No ROS, no widgets."""
