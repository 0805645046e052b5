"""What moves on a notebook's page: the parameter panel, the robot, and the other live views (ipywidgets)."""
