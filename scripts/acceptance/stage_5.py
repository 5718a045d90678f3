"""The map that one can look at and drive by (issue 11)."""

from acceptance import dense, grid, page

LINES = [*page.LINES, *grid.LINES, *dense.LINES]
