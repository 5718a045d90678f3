"""The map that lasts: the store, localisation, exports (issue 10)."""

from acceptance import exports, localising, map_kept

LINES = [*map_kept.LINES, *localising.LINES, *exports.LINES]
