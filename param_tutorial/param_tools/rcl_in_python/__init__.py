"""rclpy's own code, without a network: what rclpy has in C, for the nodes of one process, in Python.

rclpy's Python files, which decide what a parameter is and who may set it, run on this unmodified, and so do the message
classes. ``install.install()`` puts it in the place of the compiled module ``rclpy._rclpy_pybind11``, before rclpy is
imported. Messages and requests go from queue to queue: no other process can see the nodes, and no thread is started.

It is for places where the real one cannot be, such as a page in a browser. There,
``rclpy.get_rmw_implementation_identifier()`` says ``rclpy_in_python_without_network``, and so does the stage when it is
shown. The judge is the real one: tests of rclpy's behavior run on both (tests/conformance), and rclpy's own
tests run on this (tests/README.md).

Actions, lifecycle nodes, service introspection and the EventsExecutor raise NotImplementedError. Without an error,
these differ: no event reports a missed deadline or a loss of liveliness; types have no hash and no description;
messages as bytes are Python's own; logs have no files, colors or lines of rcl's own; a rejection names no file of
rcl's C code, and of ``-p`` and ``-r`` not always rcl's reason; a domain above 232 is rejected at once; and after a
shutdown in another thread, Ctrl+C is still rclpy's.
"""
