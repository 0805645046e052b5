"""The nodes of the lessons: one idea a file, rclpy and messages only.

Each file can be copied into a package of your own as it stands, and runs alone with
``ros2 run param_tutorial NAME``. Nothing here knows of notebooks.
"""
