"""A page of docs/ that a script writes: an introduction, and a section for each of its tables."""

import re

from acceptance.common import ROOT

BY_HAND = "**Reading.** "  # what follows it in a section was written by hand and stays


def markdown(head, rows):
    """A table; None is a dash, floats have two digits."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(cell(value) for value in row) + " |" for row in rows])


def rows_of(text):
    """The rows of a table as it stands in a section, by their first cell."""
    lines = [line for line in text.splitlines() if line.startswith("| ")][1:]
    rows = [tuple(line[2:-2].split(" | ")) for line in lines]
    return {row[0]: row for row in rows}


def cell(value):
    if value is None:
        return "–"
    return f"{value:.2f}" if isinstance(value, float) else str(value)


class Page:
    def __init__(self, path, introduction):
        self.path, self.introduction = path, introduction
        text = path.read_text() if path.exists() else ""
        parts = re.split(r"(?m)^## (.+)\n", text)[1:]
        self.sections = {name: body.strip() for name, body in zip(parts[::2], parts[1::2])}

    def put(self, name, text):
        """Replaces what the script wrote in that section."""
        by_hand = self.sections.get(name, "").partition(BY_HAND)
        self.sections[name] = text.strip() + ("\n\n" + BY_HAND + by_hand[2] if by_hand[1] else "")

    def write(self, order):
        """Sections in that order; those of other names go."""
        text = self.introduction.strip() + "\n"
        for name in order:
            if name in self.sections:
                text += f"\n## {name}\n\n{self.sections[name].strip()}\n"
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.path.write_text(text)


def page_path(name, quick):
    """Quick runs leave docs/ alone."""
    return ROOT / ("out/tables" if quick else "docs") / name
