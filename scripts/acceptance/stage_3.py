"""The acceptance of the third stage: as its users try it."""

from acceptance import eye, package

LINES = [*eye.LINES, *package.LINES]
