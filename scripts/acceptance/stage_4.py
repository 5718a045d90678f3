"""The map that lasts: the store, localisation, exports (issue 10)."""

from acceptance import exports, going_on, killing, localising, map_kept

LINES = [*map_kept.LINES, *going_on.LINES, *killing.LINES, *localising.LINES, *exports.LINES]
