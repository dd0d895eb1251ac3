"""Refuses a Python for which the package is not made. Every version of Python 3 can read this file."""

import sys

OLDEST = (3, 10)


def check(version: "tuple[int, ...]") -> None:
    """Raises where this Python is too old.

    >>> check((3, 10, 0))
    >>> check((3, 9, 18))
    Traceback (most recent call last):
    ImportError: lanchester needs Python 3.10 or newer, and this is Python 3.9; make an environment with a newer one (python3.12 -m venv ENVIRONMENT) and install there
    """
    if tuple(version[:2]) < OLDEST:
        raise ImportError(
            "lanchester needs Python %d.%d or newer, and this is Python %d.%d; make an environment with a newer one"
            " (python3.12 -m venv ENVIRONMENT) and install there" % (OLDEST + tuple(version[:2]))
        )


check(sys.version_info[:3])
