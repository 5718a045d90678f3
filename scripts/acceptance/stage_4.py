"""The map that lasts: the store, localisation, exports (issue 10)."""

from acceptance import exports, localising

LINES = [*localising.LINES, *exports.LINES]
