"""The acceptance of the third stage: as its users try it."""

from acceptance import bags, shell

LINES = [*bags.LINES, *shell.LINES]
