"""The real robot's pictures (issue 12)."""

from acceptance import (beside_colmap, live_speed, real_sets, robot_tours, robust_drives, speed,
                        strict_places)

LINES = [*robot_tours.LINES, *strict_places.LINES, *speed.LINES, *live_speed.LINES, *real_sets.LINES,
         *beside_colmap.LINES, *robust_drives.LINES]
