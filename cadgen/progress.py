"""The callback by which a job reports its progress. The module is light to import."""

from collections.abc import Callable

# It is called with a few words on each step as it begins, such as "planning the path".
Progress = Callable[[str], None]


def silent(text: str) -> None:
    """Report nothing."""
