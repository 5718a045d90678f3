"""The map that one can look at and drive by (issue 11)."""

from acceptance import dense, densify, grid, page, web

LINES = [*page.LINES, *web.LINES, *grid.LINES, *densify.LINES, *dense.LINES]
