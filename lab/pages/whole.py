# whole.py - results that a table is made of, and whether all of them are there
# SPDX-License-Identifier: Apache-2.0
"""What reads a result for a table reads it here, or says lack() where it has none. place.py shows a
table that lacks something on the terminal and leaves the page as it is."""
import json
from functools import lru_cache
from pathlib import Path

RTL = "rtl/**/*.v", "rtl/**/*.vh"  # what a run of the core has to be younger than
LACKING = []


def lack(what):
    """Notes that something is missing from the table that is being made; returns None."""
    LACKING.append(str(what))


@lru_cache(maxsize=None)
def _youngest(patterns):
    return max((path.stat().st_mtime for pattern in patterns for path in Path().glob(pattern)),
               default=0)


def there(path, *sources):
    """Whether a result is there and no older than the files of these patterns, if there are any."""
    path = Path(path)
    if not path.exists():
        return lack(f"no {path}")
    if path.stat().st_mtime < _youngest(sources):
        return lack(f"{path} is older than {' or '.join(sources)}")
    return True


def text(path, *sources):
    """What a result says; None if it is not there."""
    return Path(path).read_text(encoding="utf-8") if there(path, *sources) else None


def load(path, *sources):
    """A result that is JSON; None if it is not there."""
    found = text(path, *sources)
    return found and json.loads(found)


def made(table):
    """(the text of a table, what it lacks): a table is a text, or a function without arguments that
    makes it. The text is None if it could not go on without what it lacks."""
    LACKING.clear()
    try:
        return (table() if callable(table) else table), list(LACKING)
    except FileNotFoundError as fault:
        lack(f"no {fault.filename}")
    except (AttributeError, KeyError, TypeError, ValueError):
        if not LACKING:
            raise
    return None, list(LACKING)
