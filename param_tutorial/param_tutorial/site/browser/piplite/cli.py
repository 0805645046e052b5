"""What ``%pip`` does in a page."""

from collections.abc import Sequence


async def get_transformed_code(_words: Sequence[str]) -> str:
    """Return the Python code that stands in for a line with ``%pip``."""
    return ("print('There is no network in this page, so nothing can be installed. What the lessons need is here; "
            "%pip works in a checkout of the course.')\n")
