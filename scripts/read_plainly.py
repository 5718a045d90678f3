"""Files that users name: what is missing or wrong ends a script with one sentence, not with a traceback."""

import csv
import functools
import pathlib
import sys

WRONG = (ValueError, LookupError, TypeError, StopIteration, csv.Error)  # what readers trip over


class Unreadable(Exception):
    """The sentence: the file, and what is wrong with it."""


def reads(expected):
    """Of functions whose first argument is the file they read: Unreadable where it is none of the kind expected."""
    def wrap(reader):
        @functools.wraps(reader)
        def read(path, *others):
            try:
                return reader(path, *others)
            except OSError as error:
                raise Unreadable(f"{error.filename or path}: {error.strerror}") from error
            except WRONG as error:
                raise Unreadable(f"{path}: expected {expected}") from error
        return read
    return wrap


def end_plainly(main):
    """The exit status of a script's main; 1, and one sentence on standard error, where a file is at fault."""
    try:
        return main()
    except Unreadable as error:
        reason = str(error)
    except OSError as error:  # of what is written
        reason = f"{error.filename}: {error.strerror}" if error.filename else str(error)
    print(f"{pathlib.Path(sys.argv[0]).name}: {reason}", file=sys.stderr)
    return 1
