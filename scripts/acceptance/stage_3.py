"""The acceptance of the third stage: as its users try it."""

from acceptance import bags, eye, package, shell

LINES = [*bags.LINES, *shell.LINES, *eye.LINES, *package.LINES]
