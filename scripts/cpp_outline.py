"""Reads the outline of a C++ file: its functions, with signature and extent, and its classes. Knows
only what formatted sources of this package need: no macros with braces, no raw strings."""

import re
from dataclasses import dataclass, field

SCOPE = re.compile(r"\b(namespace|class|struct|union|enum)\b")
HIDDEN = re.compile(r"//[^\n]*|/\*.*?\*/|'(?:\\.|[^'\\\n])'|\"(?:\\.|[^\"\\\n])*\"|"
                    r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.DOTALL | re.MULTILINE)
LABEL = re.compile(r"^\s*(public|private|protected)\s*:")
AFTER_PARAMETERS = re.compile(
    r"(\)|\b(const|noexcept|override|final|mutable|try)|->[\w:<>,&*\s]+|[)}]\s*)\s*$")


@dataclass
class Function:
    name: str        # without its scope
    scope: str       # class that it is a member of; empty: none
    first_line: int  # of the signature
    last_line: int
    is_hidden: bool  # in an anonymous namespace


@dataclass
class Outline:
    functions: list = field(default_factory=list)  # with a body, outside of other functions
    classes: list = field(default_factory=list)    # class or struct at namespace level
    overrides: set = field(default_factory=set)    # (class, function) that another class declares


def blank(match):
    """Spaces in place of what is no code, so that lines and columns stay."""
    return re.sub(r"[^\n]", " ", match[0])


def without_nested(head):
    """The head without what stands in its round brackets."""
    while (shorter := re.sub(r"\([^()]*\)", "", head)) != head:
        head = shorter
    return head


def kind_of(head):
    """What a brace opens after this head, at the level of a namespace or a class."""
    head = re.sub(r"\boperator\s*[^\s\w(]+", "operator_", head.strip())
    outer = without_nested(head)
    if re.match(r"(inline\s+)?namespace\b|extern\b", head):
        return "namespace"
    if re.match(r"(template\s*<.*>\s*)?(class|struct|union)\b", head, re.DOTALL) and "(" not in head:
        return "class"
    if "(" in head and "=" not in outer and AFTER_PARAMETERS.search(head):
        return "function"
    return "other"


def scope_name(kind, head):
    if kind == "namespace":
        return head.split()[-1] if not head.strip().endswith("namespace") else "(anonymous)"
    if kind == "class":
        return re.search(r"\b(?:class|struct|union)\s+(?:\[\[\w+\]\]\s+)?([\w:]+)", head)[1]
    return ""


def signature(head):
    """(scope, name) of a function's head."""
    plain = re.sub(r"^\s*template\s*<[^{};]*?>\s*(?=[\w:\[])", "", head)
    named = re.search(r"((?:\w+(?:<[^<>()]*>)?::)*)(~?\w+|operator\s*\S+?)\s*\(", plain)
    if named is None:
        return "", ""
    return named[1].rstrip(":").rpartition("::")[2], named[2]


class Reader:
    def __init__(self, text):
        self.text = HIDDEN.sub(blank, text)
        self.outline = Outline()
        self.scopes = []  # (kind, name, head start)
        self.head = 0     # where the head of what comes begins

    def line_of(self, offset):
        return self.text.count("\n", 0, offset) + 1

    def head_start(self):
        label = LABEL.match(self.text, self.head)
        while label:
            self.head = label.end()
            label = LABEL.match(self.text, self.head)
        return self.head + len(self.text[self.head:]) - len(self.text[self.head:].lstrip())

    def enclosing(self, kind):
        return next((name for k, name, _ in reversed(self.scopes) if k == kind), "")

    def is_hidden(self):
        return any(k == "namespace" and name == "(anonymous)" for k, name, _ in self.scopes)

    def open(self, offset):
        start = self.head_start()
        head = self.text[start:offset]
        inner = any(kind in ("function", "other") for kind, _, _ in self.scopes)
        kind = "other" if inner else kind_of(head)
        name = scope_name(kind, head) if kind != "function" else signature(head)
        if kind == "class" and not any(k == "class" for k, _, _ in self.scopes):
            self.outline.classes.append(name)
        self.scopes.append((kind, name, start))
        if kind != "other":
            self.head = offset + 1

    def close(self, offset):
        kind, name, start = self.scopes.pop()
        if kind == "function":
            scope, plain = name
            self.note_override(self.text[start:offset].partition("{")[0], plain)
            self.outline.functions.append(
                Function(plain, scope or self.enclosing("class"), self.line_of(start),
                         self.line_of(offset), self.is_hidden()))
        if kind != "other":
            self.head = offset + 1

    def note_override(self, head, name=None):
        if self.enclosing("class") and re.search(r"\b(override|final)\b", without_nested(head)):
            self.outline.overrides.add((self.enclosing("class"), name or signature(head)[1]))

    def end_statement(self, offset):
        if any(kind in ("function", "other") for kind, _, _ in self.scopes):
            return
        self.note_override(self.text[self.head_start():offset])
        self.head = offset + 1

    def read(self):
        for found in re.finditer(r"[{};]", self.text):
            {"{": self.open, "}": self.close, ";": self.end_statement}[found[0]](found.start())
        return self.outline


def read_outline(text):
    return Reader(text).read()
