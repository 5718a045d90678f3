"""What users name: a file that is missing or wrong, or a word that means nothing, ends a script with one sentence,
not with a traceback."""

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


def take_words(doc, most=0):
    """The words of the command line of a script that has no options; --help prints doc, the script's own."""
    words = [word for word in sys.argv[1:] if ":=" not in word]  # those are of ROS
    if "-h" in words or "--help" in words:
        print(doc)
        sys.exit(0)
    options = [word for word in words if word.startswith("-")]
    for word in options + words[most:]:
        expected = f"at most {most} and no option" if most else "no argument"
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: '{word}': expected {expected}; --help tells more")
    return words
