"""rcl's own parser of parameter files, where it is installed: it says whether a node would get a file. No rclpy.

The library librcl_yaml_param_parser.so is part of every ROS and of the ROS wheels. Both make it known to the dynamic
loader, so its name is enough to find it. Ask it only about files that ``parsing`` accepts: for some of the others it
reads past the end of its arrays, which ends the process. One is a block of 200 parameters, and after it a block that
stands there for the second time and holds a single value instead of parameters.
"""

import ctypes
import functools
import os
from collections.abc import Sequence
from pathlib import Path


class _Allocator(ctypes.Structure):
    """rcutils_allocator_t."""

    _fields_ = tuple((name, ctypes.c_void_p) for name in ('allocate', 'deallocate', 'reallocate', 'zero_allocate',
                                                          'state'))


class _ErrorString(ctypes.Structure):
    """rcutils_error_string_t."""

    _fields_ = (('text', ctypes.c_char * 1024),)


@functools.cache
def _library() -> ctypes.CDLL | None:
    """Return rcl's library; None where ROS is not installed."""
    try:
        library = ctypes.CDLL('librcl_yaml_param_parser.so')
    except OSError:
        return None
    library.rcutils_get_default_allocator.restype = _Allocator
    library.rcutils_get_error_string.restype = _ErrorString
    library.rcl_yaml_node_struct_init.argtypes = [_Allocator]
    library.rcl_yaml_node_struct_init.restype = ctypes.c_void_p
    library.rcl_yaml_node_struct_fini.argtypes = [ctypes.c_void_p]
    library.rcl_parse_yaml_file.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    library.rcl_parse_yaml_file.restype = ctypes.c_bool
    return library


def first_rejection(paths: Sequence[str | Path]) -> tuple[int, str] | None:
    """Return which of some files rcl rejects, as an index, and its reason; None if it rejects none, or isn't installed.

    :param paths: Files that a node gets together, in this order. What is not a regular file ends the reading: a pipe
        could not be read twice.
    """
    library = _library()
    if library is None:
        return None
    parameters = library.rcl_yaml_node_struct_init(library.rcutils_get_default_allocator())
    try:
        for index, path in enumerate(paths):
            if not Path(path).is_file():
                break
            if not library.rcl_parse_yaml_file(os.fsencode(path), parameters):
                reason = library.rcutils_get_error_string().text.decode(errors='replace')
                library.rcutils_reset_error()
                return index, reason.partition(', at /')[0].strip()  # without the place in rcl's source
        return None
    finally:
        library.rcl_yaml_node_struct_fini(parameters)
