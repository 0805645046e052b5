"""Words that pictures, tools and messages share."""


def format_count(count: int, what: str) -> str:
    """Return a number with its noun, which is in the singular for one."""
    return f'{count} {what}{"" if count == 1 else "s"}'
