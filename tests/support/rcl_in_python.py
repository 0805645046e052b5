"""A pytest plugin: ``-p tests.support.rcl_in_python`` has rclpy stand on its layer in Python."""

import pytest

from param_tools.rcl_in_python.install import install

install(even_beside_the_real_one=True)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out the tests that are about what this layer doesn't have."""
    left_out = [item for item in items if item.get_closest_marker('real_layer')]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if item not in left_out]
