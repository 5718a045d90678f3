"""The map that one can look at and drive by (issue 11)."""

from acceptance import dense, densify, grid, page

LINES = [*page.LINES, *grid.LINES, *densify.LINES, *dense.LINES]
