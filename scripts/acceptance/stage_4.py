"""The map that lasts: the store, localisation, exports (issue 10)."""

from acceptance import exports, killing, localising, map_kept

LINES = [*map_kept.LINES, *killing.LINES, *localising.LINES, *exports.LINES]
